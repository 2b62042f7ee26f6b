#include "viewer/tools/Canvas.h"

#include <cmath>

namespace fenestra::viewer {

QPointF Canvas::pixelsPerMm(glm::dvec3 at, glm::dvec3 along) const {
  const std::optional<QPointF> from = widgetFromWorld(at), to = widgetFromWorld(at + along);
  return from && to ? *to - *from : QPointF();
}

double Canvas::pixelsOf(double mm, glm::dvec3 at) const {
  const QPointF across = pixelsPerMm(at, mm * axes().right);
  return std::hypot(across.x(), across.y());
}

Camera::Axes SliceCanvas::axes() const {
  const glm::dvec3 across = glm::normalize(right()), up = -glm::normalize(down());
  return {across, up, glm::normalize(glm::cross(up, across))};
}

std::optional<Canvas::Section> SliceCanvas::section() const {
  return Section{geometry().worldFromPixel(0.0, 0.0, slice()),
                 glm::normalize(glm::cross(geometry().right, geometry().down))};
}

}  // namespace fenestra::viewer
