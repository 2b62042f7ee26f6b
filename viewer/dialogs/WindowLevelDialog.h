#pragma once
// Window and level by number. What is typed shows at once; the slices' own gestures show here.

#include <QDialog>
#include <QDoubleSpinBox>

namespace fenestra::viewer {

class Document;

class WindowLevelDialog : public QDialog {
  Q_OBJECT
 public:
  /// `document` outlives this.
  explicit WindowLevelDialog(Document& document, QWidget* parent = nullptr);

  QDoubleSpinBox* windowWidth() const { return width_; }
  QDoubleSpinBox* level() const { return level_; }

 private:
  void follow();

  Document& document_;
  QDoubleSpinBox *width_, *level_;
};

}  // namespace fenestra::viewer
