#pragma once
// A picture of the curved reformat, under the slices' window: straightened, or across the path.
//
// The mouse does what it does on a slice: a click goes to a place, a drag changes window and level, the wheel and the
// arrows step along the path, Shift+move follows the mouse.

#include <functional>
#include <optional>
#include <vector>

#include <QImage>
#include <QWidget>

#include "rendering/volume/Volume.h"

namespace fenestra::viewer {

class Document;

class ReformatPicture : public QWidget {
  Q_OBJECT
 public:
  /// Pixels of real values, row by row from the top; NaN is black.
  struct Pixels {
    int width = 0, height = 0;
    double spacing = 1.0;  ///< mm from each to the next
    std::vector<float> values;
  };

  /// `document` outlives this.
  explicit ReformatPicture(Document& document, QWidget* parent = nullptr);

  void setPixels(Pixels pixels);
  const Pixels& pixels() const { return pixels_; }
  /// The row at which a line lies across the picture, in pixels from the top; empty: a cross in the middle.
  void setLine(std::optional<double> row);
  std::optional<double> line() const { return line_; }
  /// Where the picture lies in the widget.
  QRectF shownIn() const;

  QSize sizeHint() const override { return {150, 300}; }
  QSize minimumSizeHint() const override { return {80, 80}; }

 Q_SIGNALS:
  /// A click, or the mouse with Shift held, on the picture: mm from the middle of its first row.
  void chosen(double mm);
  /// The wheel or a key: steps along the path, of about a voxel.
  void stepped(int steps);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void choose(QPointF position);

  Document& document_;
  Pixels pixels_;
  std::optional<double> line_;
  QImage image_;  ///< null until it is made
  QPointF pressed_;
  WindowLevel windowAtPress_;
  bool dragging_ = false;
  double wheel_ = 0.0;  ///< eighths of a degree that are not yet a notch
};

}  // namespace fenestra::viewer
