#pragma once
// Warnings about the data, and errors, in a bar above the pictures. A notice never blocks the window and stays until
// the user dismisses it or opens another study. Only the first few show; a button unfolds the others.

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

  /// Adds a notice unless the same text is shown already. With an `action`, the notice has a button called
  /// `actionName`.
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
