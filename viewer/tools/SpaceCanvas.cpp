#include "viewer/tools/SpaceCanvas.h"

#include <cmath>

namespace fenestra::viewer {

double SpaceCanvas::pixelsOf(double mm, glm::dvec3 at) const {
  const std::optional<QPointF> from = widgetFromWorld(at);
  const std::optional<QPointF> to = widgetFromWorld(at + mm * axes(at).right);
  if (!from || !to) return 0.0;
  return std::hypot(to->x() - from->x(), to->y() - from->y());
}

}  // namespace fenestra::viewer
