#pragma once
// The path of the straightened picture in one view (PathMode): shown in all of them, drawn by clicks on slices.
//
// While a path is drawn, a left click on a slice adds a point; Backspace takes the last one away, Enter or a double
// click ends. The middle and the right button, and the wheel, do what they usually do, so that a path can go through
// slices.

#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Canvas;
class PathMode;
class ViewOptions;

class PathTool : public Tool {
 public:
  /// All outlive this.
  PathTool(PathMode& mode, const ViewOptions& options, const Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void hover(const QMouseEvent& event) override;
  void leave() override;
  bool key(const QKeyEvent& event) override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  /// On a slice, what lies farther from it than the crosshair's slice could show is faint.
  void draw(QPainter& painter, const QRectF& view) const override;

 private:
  bool draws() const;

  PathMode& mode_;
  const ViewOptions& options_;
  const Canvas& canvas_;
};

}  // namespace fenestra::viewer
