#pragma once
// Handles in a 3-D view or on a slice: which one the mouse is over, and how far a drag moves it along its way.

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <QLineF>
#include <QPointF>

#include <glm/glm.hpp>

namespace fenestra::viewer {

/// Device-independent pixels: how near to a handle the mouse takes it, and half of the side it is drawn with.
inline constexpr double handleReach = 9.0, handleRadius = 5.0;

/// The nearest handle within handleReach of a position in the widget; of equally near ones the last. `at` of a handle
/// is its world position.
template <class Handle>
std::optional<Handle> handleNear(const std::vector<Handle>& handles,
                                 const std::function<std::optional<QPointF>(glm::dvec3)>& widgetFromWorld,
                                 QPointF position) {
  std::optional<Handle> nearest;
  double least = handleReach;
  for (const Handle& handle : handles)
    if (const auto at = widgetFromWorld(handle.at))
      if (const double distance = QLineF(*at, position).length(); distance <= least) {
        least = distance;
        nearest = handle;
      }
  return nearest;
}

/// Sine of the angle between a handle's way and the line of sight below which a drag does not follow the way.
inline constexpr double leastDragAngle = 0.1;

/// mm along `along` (world, unit) from `at` that the mouse has moved by so many device-independent pixels; `right` is
/// the picture's right in the world.
inline double draggedAlong(const std::function<std::optional<QPointF>(glm::dvec3)>& widgetFromWorld, glm::dvec3 right,
                           glm::dvec3 at, glm::dvec3 along, QPointF moved) {
  const auto pixelsPerMm = [&](glm::dvec3 direction) {
    const auto from = widgetFromWorld(at), to = widgetFromWorld(at + direction);
    return from && to ? *to - *from : QPointF();
  };
  const QPointF way = pixelsPerMm(along), across = pixelsPerMm(right);
  const double square = QPointF::dotProduct(way, way), most = QPointF::dotProduct(across, across);
  if (!(most > 0.0)) return 0.0;
  // Seen along its way, a handle follows the mouse up and down the picture.
  if (square < leastDragAngle * leastDragAngle * most) return -moved.y() / std::sqrt(most);
  return QPointF::dotProduct(moved, way) / square;
}

}  // namespace fenestra::viewer
