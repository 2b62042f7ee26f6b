#include "rendering/reference/Exploded.h"

#include <algorithm>
#include <cmath>

#include "rendering/reference/Blend.h"
#include "rendering/reference/Unknown.h"
#include "rendering/scene/Explosion.h"
#include "rendering/scene/Lighting.h"

namespace fenestra::reference {
namespace {

constexpr Span missed{1.0, 0.0};

/// Stretches of all rays in one part, or in the focus, and what they show.
struct Stretches {
  std::vector<CutRay> rays;
  FocusLayer layer;
};

/// The stretch of a part that a ray sees from `begin` to `end`, mm along it.
CutRay stretchOf(const Scene& scene, const std::vector<HalfSpace>& kept, const Ray& ray, double begin, double end) {
  const Grid& grid = scene.volume->grid;
  CutRay cut{.ray = ray, .span = missed};
  const std::optional<Span> inside = clip(ray, grid, kept);
  if (!inside) return cut;
  cut.span = {std::max(inside->tIn, begin), std::min(inside->tOut, end)};
  const auto normal = capNormal(ray, grid, kept);
  if (!normal) return cut;
  cut.wall = *normal;
  cut.beforeWall = cut.span.tIn - inside->tIn;
  const double depth = lighting::wallDepthVoxels * std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
  if (scene.look.clipping.grey && cut.beforeWall <= 0.5 * depth) cut.grey = GreyFace{*scene.look.clipping.grey, true};
  return cut;
}

/// Ray i, its stretches laid over each other from the nearest on.
glm::dvec4 composed(const std::vector<Stretches>& all, std::size_t i) {
  std::vector<std::pair<double, glm::dvec4>> seen;
  for (const Stretches& each : all)
    if (each.rays[i].span.tIn <= each.rays[i].span.tOut) seen.emplace_back(each.rays[i].span.tIn, each.layer.colour[i]);
  std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  glm::dvec4 colour(0.0);
  for (const auto& [begin, stretch] : seen) colour = over(colour, stretch);
  return colour;
}

}  // namespace

FocusLayer explodedLayer(const Scene& scene, const Camera& camera, glm::ivec2 size,
                         const std::vector<glm::dvec2>& places, double tolerance) {
  const Grid& grid = scene.volume->grid;
  const MethodStages::Explosion explosion = *explosionOf(scene.look);
  const std::vector<ExplodedPart> parts = ExplodedView(explosion, grid, focusCentre(scene), camera).parts();
  const std::vector<HalfSpace> clipped = halfSpaces(scene.look.clipping, grid);
  const Image tFocus = hitPoints(scene, camera, size, places).tFocus;
  // This is the greatest number of stretches that a ray meets: each plane parts it once, and the focus once more.
  const double each = tolerance / (explosion.planes + 3);

  std::vector<Stretches> all(1);  // the focus before what begins where it does
  for (std::size_t i = 0; i < places.size(); ++i) {
    CutRay focus = stretchOf(scene, clipped, rayThrough(camera, size, places[i]), tFocus[i], infinity);
    if (std::isnan(tFocus[i])) focus.span = missed;
    focus.grey.reset();
    all.front().rays.push_back(focus);
  }
  all.front().layer = layerOf(Alone::InFocus, scene, camera, all.front().rays, each);
  for (const ExplodedPart& part : parts) {
    std::vector<HalfSpace> kept = clipped;
    kept.insert(kept.end(), part.kept.begin(), part.kept.end());
    Stretches before, behind;
    for (std::size_t i = 0; i < places.size(); ++i) {
      Ray ray = rayThrough(camera, size, places[i]);
      ray.origin -= part.translation;
      const double hit = std::isnan(tFocus[i]) ? infinity : tFocus[i];
      before.rays.push_back(stretchOf(scene, kept, ray, 0.0, hit));
      behind.rays.push_back(stretchOf(scene, kept, ray, hit, infinity));
    }
    for (Stretches* stretches : {&before, &behind}) {
      stretches->layer = layerOf(Alone::OutsideFocus, scene, camera, stretches->rays, each);
      all.push_back(std::move(*stretches));
    }
  }
  FocusLayer result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    result.colour.push_back(composed(all, i));
    double& error = result.error.emplace_back(0.0);
    for (const Stretches& stretches : all) error += stretches.layer.error[i];
  }
  return result;
}

}  // namespace fenestra::reference
