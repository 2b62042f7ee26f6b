#pragma once
// Handles in a 3-D view or on a slice: which one the mouse is over, and how far a drag moves it along its way.

#include <cmath>
#include <optional>
#include <vector>

#include <QLineF>
#include <QPointF>

#include <glm/glm.hpp>

#include "viewer/tools/Canvas.h"

namespace fenestra::viewer {

/// Device-independent pixels: how near to a handle the mouse takes it, and half of the side it is drawn with.
inline constexpr double handleReach = 9.0, handleRadius = 5.0;

/// The nearest handle within handleReach of a position in the view; the last of several that are equally near. `at` of
/// a handle is its world position.
template <class Handle>
std::optional<Handle> handleNear(const std::vector<Handle>& handles, const Canvas& canvas, QPointF position) {
  std::optional<Handle> nearest;
  double least = handleReach;
  for (const Handle& handle : handles)
    if (const auto at = canvas.widgetFromWorld(handle.at))
      if (const double distance = QLineF(*at, position).length(); distance <= least) {
        least = distance;
        nearest = handle;
      }
  return nearest;
}

/// Sine of the angle between a handle's way and the line of sight below which a drag does not follow the way.
inline constexpr double leastDragAngle = 0.1;

/// mm along `along` (world, unit) from `at` that the mouse has moved by so many device-independent pixels.
inline double draggedAlong(const Canvas& canvas, glm::dvec3 at, glm::dvec3 along, QPointF moved) {
  const QPointF way = canvas.pixelsPerMm(at, along), across = canvas.pixelsPerMm(at, canvas.axes().right);
  const double square = QPointF::dotProduct(way, way), most = QPointF::dotProduct(across, across);
  if (!(most > 0.0)) return 0.0;
  // Seen along its way, a handle follows the mouse up and down the picture.
  if (square < leastDragAngle * leastDragAngle * most) return -moved.y() / std::sqrt(most);
  return QPointF::dotProduct(moved, way) / square;
}

}  // namespace fenestra::viewer
