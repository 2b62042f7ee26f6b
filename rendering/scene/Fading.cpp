#include "rendering/scene/Fading.h"

#include <algorithm>

#include "rendering/settings/Look.h"

namespace fenestra {

std::optional<MethodStages::Fading> fadingOf(const Look& look) {
  if (!look.cutaway.enabled) return std::nullopt;
  const std::optional<MethodStages::Fading> fading = stagesOf(look.method).fading;
  return fading && fading->ghost && std::holds_alternative<std::monostate>(look.focus) ? std::nullopt : fading;
}

bool fadesByDistance(const Look& look) {
  const std::optional<MethodStages::Fading> fading = fadingOf(look);
  return fading && fading->region && fading->region->shape == FocalShape::Distance;
}

double steepestSlope(const Volume& volume) {
  const glm::dvec3 spacing = volume.grid.spacing;
  return 0.5 * (volume.range.high - volume.range.low) / std::min({spacing.x, spacing.y, spacing.z});
}

double EyeRange::distance(double t) const {
  return farthest > nearest ? std::clamp((t - nearest) / (farthest - nearest), 0.0, 1.0) : 0.0;
}

EyeRange eyeRangeOf(const Camera& camera, const Grid& grid) {
  const glm::dvec3 centre = grid.centre() - camera.eye;
  const double middle =
      camera.projection == Projection::Perspective ? glm::length(centre) : glm::dot(centre, camera.axes().forward);
  const double radius = grid.boundingRadius();
  return {std::max(middle - radius, 0.0), std::max(middle + radius, 0.0)};
}

}  // namespace fenestra
