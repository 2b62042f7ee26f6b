#pragma once
// The lines in which the other two planes cut a slice, as its crosshair shows them, with handles that turn those
// planes: a drag turns a plane about this slice's normal, through the crosshair. Positions are in device-independent
// pixels of the view.
//
// Handles show with the crosshair while the mouse is in the view, but not while a stroke mode is active. Shift holds
// the line to the picture's rows, columns and diagonals; Ctrl turns both planes. Turning is no step to undo (see
// SlicePlanes.h).

#include <array>
#include <optional>
#include <vector>

#include <QPointF>

#include "rendering/volume/ObliqueSlice.h"
#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class SliceCanvas;
struct Workspace;

/// Where another plane cuts a slice.
struct PlaneCut {
  SlicePlane plane;
  QPointF at;     ///< the point of the line nearest to the crosshair
  QPointF along;  ///< unit
};

class PlaneTool : public Tool {
 public:
  struct Handle {
    SlicePlane plane;
    QPointF at;
    bool operator==(const Handle&) const = default;
  };

  /// Both outlive this.
  PlaneTool(Workspace& workspace, const SliceCanvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  bool wasClick() const override { return !drags_; }
  void hover(const QMouseEvent& event) override;
  void leave() override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  void draw(QPainter& painter, const QRectF& view) const override;

  /// One line for each other plane that is not parallel to the slice. There must be a volume.
  std::vector<PlaneCut> cuts() const;
  /// Two on each line, as far from the crosshair as the view has room; none while they may not be dragged.
  std::vector<Handle> handles() const;
  /// Degrees, -90 to 90, clockwise in the picture: of a plane's line from where the volume's own slice has it.
  double angle(SlicePlane plane) const;

 private:
  /// The unit direction, in the view, of a plane's line; empty where the plane is parallel to the slice.
  std::optional<QPointF> directionOf(const PlaneAxes& axes) const;
  std::optional<Handle> handleAt(QPointF position) const;
  void endDrag();
  void drawAngle(QPainter& painter, const QRectF& view) const;

  Workspace& workspace_;
  const SliceCanvas& canvas_;
  std::optional<Handle> grip_;         ///< being dragged
  std::array<PlaneAxes, 3> before_{};  ///< at the press
  QPointF pressed_, mouse_;
  double lineBefore_ = 0.0;  ///< radians, of the grip's line in the view at the press
  bool drags_ = false;       ///< the mouse has moved farther than in a click
  bool hovers_ = false;      ///< the mouse is in the view
};

}  // namespace fenestra::viewer
