#pragma once
// Handles on the slices of walls (rendering/scene/Walls.h) in a 3-D view: dragging one moves its slice through the
// volume, and the crosshair with it. A handle lies where its slice leaves the volume's box, in the middle of the side
// that is nearest to the eye, wherever the wall stands. Handles show with the crosshair, but not while a stroke mode is
// active. Positions are in device-independent pixels of the view.

#include <optional>
#include <vector>

#include <QPointF>

#include "rendering/volume/Slice.h"
#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class ActiveTool;
class Canvas;
class Document;
class SliceCursor;
class ViewOptions;

class WallTool : public Tool {
 public:
  struct Handle {
    SlicePlane plane;
    glm::dvec3 at;     ///< world
    glm::dvec3 along;  ///< unit, world: towards slices of higher voxel indices
  };

  /// All outlive this.
  WallTool(const Document& document, SliceCursor& cursor, const ViewOptions& options, const ActiveTool& active,
           const Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  void draw(QPainter& painter, const QRectF& view) const override;

  /// One for each slice that is a wall; none while they do not show.
  std::vector<Handle> handles() const;

 private:
  std::optional<Handle> handleAt(QPointF position) const;

  const Document& document_;
  SliceCursor& cursor_;
  const ViewOptions& options_;
  const ActiveTool& active_;
  const Canvas& canvas_;
  std::optional<Handle> grip_;  ///< being dragged
  glm::dvec3 before_{0.0};      ///< the crosshair at the press
  QPointF pressed_;
};

}  // namespace fenestra::viewer
