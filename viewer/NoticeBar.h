#pragma once
// What the user must know, above the pictures and out of the way: warnings about the data, and errors. Nothing here
// stops the work; a notice stays until it is dismissed or replaced. Beyond a few, the rest is folded away.

#include <functional>
#include <vector>

#include <QWidget>

#include "io/VolumeReader.h"

class QPushButton;
class QVBoxLayout;

namespace fenestra::viewer {

class NoticeBar : public QWidget {
  Q_OBJECT
 public:
  enum class Kind : std::uint8_t { Warning, Error };

  explicit NoticeBar(QWidget* parent = nullptr);

  /// A notice that is already shown is not repeated. `action` makes a button called `actionName`.
  void add(Kind kind, const QString& text, const QString& actionName = {}, std::function<void()> action = {});
  /// A reader's warnings, each with the files that it concerns.
  void addWarnings(const std::vector<io::Warning>& warnings);
  void clear();
  /// The texts shown, from the top.
  QStringList texts() const;

 private:
  void fold();

  QVBoxLayout* rows_;
  QPushButton* unfold_;
  bool unfolded_ = false;
};

}  // namespace fenestra::viewer
