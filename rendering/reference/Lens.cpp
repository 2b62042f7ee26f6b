#include "rendering/reference/Lens.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/reference/ContextLayer.h"
#include "rendering/reference/Unknown.h"

namespace fenestra::reference {
namespace {

/// A pixel and those beside it.
constexpr std::array<glm::ivec2, 5> cross{
    {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}};

/// Where the line of sight to a place first meets anything; that place itself where it does not.
glm::dvec3 seenTowards(glm::dvec3 place, const Scene& scene, const Camera& camera) {
  const std::optional<Camera> aimed = camera.aimedAt(place);
  if (!aimed) return place;
  const double t = hitPoints(scene, *aimed, glm::ivec2(1)).tContext[0];
  const Ray ray = pixelRay(*aimed, glm::ivec2(1), glm::ivec2(0));
  return std::isnan(t) ? place : ray.origin + t * ray.direction;
}

/// b: the share that stays without regard to bends, at `place` radii from the middle; `before`: radii of context before
/// the focus, NaN beside the focus.
double keptBesideBends(LensFade fade, double place, double before) {
  if (place >= 1.0) return 1.0;
  if (fade == LensFade::Distance) return place;
  if (fade == LensFade::Curvature) return 0.0;
  return std::isnan(before) ? 1.0 : std::clamp(before, 0.0, 1.0);
}

}  // namespace

std::vector<LensPoint> lensPoints(const Scene& scene, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
                                  const std::vector<glm::ivec2>& pixels, const ShownSlices& slices) {
  const MethodStages::Lens lens = *stagesOf(scene.look.method).lens;
  const Grid& grid = scene.volume->grid;
  const double radius = radiusOf(lens, grid);
  const double margin = 0.5 * std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
  const glm::dvec3 middle = seenTowards(placeOf(lens, slices, focusCentre(scene)), scene, camera);
  const Camera::Axes axes = camera.axes();

  std::vector<Ray> rays;
  Image tContext, tFocus;
  for (const glm::ivec2 pixel : pixels)
    for (const glm::ivec2 step : cross) {
      const glm::ivec2 at = glm::clamp(pixel + step, glm::ivec2(0), size - 1);
      const std::size_t i =
          static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(at.x);
      rays.push_back(pixelRay(camera, size, at));
      tContext.push_back(hits.tContext[i]);
      tFocus.push_back(hits.tFocus[i]);
    }
  const std::vector<glm::dvec3> normals = contextNormals(scene, rays, tContext, tFocus);
  const auto seen = [&](std::size_t i) {
    return glm::dvec3(glm::dot(normals[i], axes.right), glm::dot(normals[i], axes.up),
                      glm::dot(normals[i], axes.forward));
  };

  std::vector<LensPoint> points;
  points.reserve(pixels.size());
  for (std::size_t i = 0; i < rays.size(); i += cross.size()) {
    LensPoint point{seen(i), unknown, 1.0, 0.0};
    const bool isSurface = !std::isnan(tContext[i]) && (std::isnan(tFocus[i]) || tContext[i] < tFocus[i] - margin);
    if (isSurface) {
      glm::dvec3 bend(0.0);
      for (std::size_t k = 1; k < cross.size(); ++k) bend += glm::abs(seen(i + k) - point.normal);
      point.distance = glm::distance(rays[i].origin + tContext[i] * rays[i].direction, middle);
      const double place = point.distance / radius;
      const double kept = keptBesideBends(lens.fade, place, (tFocus[i] - tContext[i]) / radius);
      point.share = std::clamp(std::max(glm::length(bend) * lens.bends, kept), 0.0, 1.0);
      point.line = 0.5 * (1.0 - std::clamp(std::abs(place - 1.0) * lens.rim, 0.0, 1.0));
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace fenestra::reference
