#pragma once
// What a tool that acts on places in space needs of its view, in 3-D or of a slice. Positions are in device-independent
// pixels of the view.

#include <functional>
#include <optional>

#include <QPointF>

#include "viewer/model/Carving.h"

namespace fenestra::viewer {

/// All may be called at any time.
struct SpaceCanvas {
  /// The point that is seen at a place of the view, world; empty where there is nothing.
  std::function<std::optional<glm::dvec3>(QPointF)> pick;
  /// Empty behind the eye.
  std::function<std::optional<QPointF>(glm::dvec3)> widgetFromWorld;
  /// The view's axes at a point: forward is the line of sight there.
  std::function<CarvingAxes(glm::dvec3)> axes;
  std::function<void()> redraw;

  /// Pixels of a length in mm across the view at a point; 0 behind the eye.
  double pixelsOf(double mm, glm::dvec3 at) const;
};

}  // namespace fenestra::viewer
