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

  /// Views that a picture may show, each alone and together.
  struct Choice {
    QString name;
    PictureMaker::Request views;
  };
  /// Those that are on screen.
  static std::vector<Choice> choices(What what, const ViewArea& views);
  /// The choice of the active view alone; 0 where that is none of them.
  static int activeOf(const std::vector<Choice>& choices, const ViewArea& views);

 private:
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
