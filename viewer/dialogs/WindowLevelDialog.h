#pragma once
// Window and level by number. A typed number takes effect at once, and a drag on a slice changes the numbers.

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
