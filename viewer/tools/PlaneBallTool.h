#pragma once
// The three slices' planes in a 3-D view: the outline in which each cuts the volume, and a ball at the tip of its
// normal, through the crosshair, that turns it. Positions are in device-independent pixels of the view.
//
// They show while ViewOptions::planes() is on, but not while a stroke mode is active. Turning is no step to undo (see
// SlicePlanes.h).

#include <optional>
#include <vector>

#include <QPointF>

#include "rendering/volume/ObliqueSlice.h"
#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Canvas;
struct Workspace;

class PlaneBallTool : public Tool {
 public:
  struct Handle {
    SlicePlane plane;
    glm::dvec3 at;     ///< world, the ball
    glm::dvec3 along;  ///< unit, world: from the crosshair to the ball; the side of the normal that faces the eye
  };

  /// Both outlive this.
  PlaneBallTool(Workspace& workspace, const Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  void leave() override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  void draw(QPainter& painter, const QRectF& view) const override;

  /// One for each plane; none while they do not show.
  std::vector<Handle> handles() const;

 private:
  Handle handleOf(SlicePlane plane) const;
  void drawOutline(QPainter& painter, SlicePlane plane) const;

  Workspace& workspace_;
  const Canvas& canvas_;
  std::optional<Handle> grip_;  ///< being dragged, as at the press
  PlaneAxes before_;            ///< at the press
  QPointF pressed_;
};

}  // namespace fenestra::viewer
