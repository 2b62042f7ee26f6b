#pragma once
// Handles on the slices of walls (rendering/scene/Walls.h) in a 3-D view: dragging one moves its slice through the
// volume, and the crosshair with it. A handle lies where its slice leaves the volume's box, in the middle of the side
// that is nearest to the eye, wherever the wall stands. Positions are in device-independent pixels of the view.

#include <functional>
#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>

#include "rendering/scene/Slice.h"

class QMouseEvent;

namespace fenestra::viewer {

class Document;
class SliceCursor;

class WallTool {
 public:
  /// What the tool needs of its view.
  struct Canvas {
    /// Empty behind the eye.
    std::function<std::optional<QPointF>(glm::dvec3)> widgetFromWorld;
    /// Unit vectors, world: to the picture's right, and away from the eye.
    std::function<std::array<glm::dvec3, 2>()> axes;
    std::function<bool()> shows;
  };
  struct Handle {
    SlicePlane plane;
    glm::dvec3 at;     ///< world
    glm::dvec3 along;  ///< unit, world: towards slices of higher voxel indices
  };

  WallTool(const Document& document, SliceCursor& cursor, Canvas canvas);

  /// Handle an event. True: the tool has taken it, and the view must ignore it.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);

  /// Over a handle, the pointer's shape.
  std::optional<Qt::CursorShape> pointer(QPointF position) const;
  /// Of the slices that are walls; none while the tool does not show.
  std::vector<Handle> handles() const;
  void draw(QPainter& painter) const;

 private:
  std::optional<Handle> handleAt(QPointF position) const;

  const Document& document_;
  SliceCursor& cursor_;
  Canvas canvas_;
  std::optional<Handle> grip_;  ///< being dragged
  glm::dvec3 before_{0.0};      ///< the crosshair at the press
  QPointF pressed_;
};

}  // namespace fenestra::viewer
