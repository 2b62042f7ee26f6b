#pragma once
// Asks for the views, the size and the marks of a saved picture, and for the number of pictures of a turntable.

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QSpinBox>

#include "viewer/views/PictureMaker.h"

namespace fenestra::viewer {

class ViewArea;

class PictureDialog : public QDialog {
  Q_OBJECT
 public:
  enum class What { Picture, Turntable };
  /// Offers the views that are on screen, of which there is at least one; for a turntable, only 3-D views.
  /// `views` and `maker` outlive this.
  PictureDialog(What what, const ViewArea& views, const PictureMaker& maker, QWidget* parent = nullptr);

  PictureMaker::Request request() const;
  int frames() const { return frames_->value(); }
  int framesPerSecond() const { return framesPerSecond_->value(); }

 private:
  struct Choice {
    QString name;
    PictureMaker::Request views;
  };
  static std::vector<Choice> choices(What what, const ViewArea& views);
  /// The other side follows, so that the picture shows what the window does.
  void sizeChanged(QSpinBox* changed, QSpinBox* follows);
  QSize shownSize() const;

  const PictureMaker& maker_;
  std::vector<Choice> choices_;
  QComboBox* views_;
  QSpinBox *width_, *height_;
  QCheckBox* marks_;
  QSpinBox *frames_, *framesPerSecond_;
};

}  // namespace fenestra::viewer
