#pragma once
// The path of the straightened picture in one view (PathMode): shown in all of them, drawn by clicks on slices.
//
// While a path is drawn, a left click on a slice adds a point; Backspace takes the last one away, Enter or a double
// click ends. The middle and the right button, and the wheel, do what they usually do, so that a path can go through
// slices. Afterwards its points that lie on a slice are dragged there.

#include <vector>

#include <glm/glm.hpp>

#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Canvas;
class Document;
class PathMode;
class ViewOptions;

class PathTool : public Tool {
 public:
  /// All outlive this.
  PathTool(PathMode& mode, Document& document, const ViewOptions& options, const Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  bool wasClick() const override { return grip_ && !dragging_; }
  void hover(const QMouseEvent& event) override;
  void leave() override;
  bool key(const QKeyEvent& event) override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  /// On a slice, what lies farther from it than the crosshair's slice could show is faint.
  void draw(QPainter& painter, const QRectF& view) const override;

 private:
  struct Grip {
    std::size_t point;
    QPointF pressed;
    glm::dvec3 from;                 ///< where the mouse was pressed on the slice
    std::vector<glm::dvec3> before;  ///< the path when it was pressed
    std::vector<glm::dvec3> held;    ///< the path as the drag has left it
  };

  bool draws() const;
  /// Whether a point lies so near to the slice that it counts as on it; never in 3-D.
  bool isHere(glm::dvec3 point) const;
  /// The path's point on this slice at a position.
  std::optional<std::size_t> pointAt(QPointF position) const;

  PathMode& mode_;
  Document& document_;
  const ViewOptions& options_;
  const Canvas& canvas_;
  std::optional<Grip> grip_;
  bool dragging_ = false;
};

}  // namespace fenestra::viewer
