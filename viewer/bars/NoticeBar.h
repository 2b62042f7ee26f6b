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

  /// A button of a notice.
  struct Action {
    QString name;
    std::function<void()> run;
  };
  /// Adds a notice unless the same text is shown already. `withoutNames` stands for a text that may name the patient
  /// while names are hidden.
  void add(Kind kind, const QString& text, const std::vector<Action>& actions = {}, const QString& withoutNames = {});
  void hideNames(bool hide);
  /// A reader's warnings, each with the files that it concerns.
  void addWarnings(const std::vector<io::Warning>& warnings);
  /// What is odd about a series' slices and where they are shown, with a button for the whole report and one for each
  /// other way to place them.
  void addGeometry(const io::GeometryReport& report, const std::function<void(io::Regularise)>& choose);
  void clear();
  /// The texts shown, from the top.
  QStringList texts() const;

 private:
  void fold();

  QVBoxLayout* rows_;
  QPushButton* unfold_;
  bool unfolded_ = false, hidesNames_ = false;
};

}  // namespace fenestra::viewer
