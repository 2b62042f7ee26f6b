// Cones on the focus in double precision: what rendering/passes/ConePass.h defines, by a search of all focus hits.

#include <algorithm>
#include <cmath>

#include "rendering/reference/Reference.h"
#include "rendering/reference/Unknown.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

/// Depths on the rays of a picture, mm along the view from the eye or its plane.
class Depths {
 public:
  Depths(const Camera& camera, glm::ivec2 size) : camera_(camera), size_(size), forward_(camera.axes().forward) {}

  bool perspective() const { return camera_.projection == Projection::Perspective; }
  /// Depth of t = 1 on a pixel's ray.
  double perTime(glm::ivec2 pixel) const { return glm::dot(pixelRay(camera_, size_, pixel).direction, forward_); }
  /// From one pixel to the next across the picture: mm, or in perspective mm at a depth of 1 mm.
  double pitch() const {
    return perspective() ? 2.0 * std::tan(0.5 * glm::radians(camera_.verticalFov)) / size_.y
                         : camera_.orthographicHeight / size_.y;
  }

 private:
  Camera camera_;
  glm::ivec2 size_;
  glm::dvec3 forward_;
};

/// What a cone stands on.
struct Apex {
  int x = 0;
  double depth = 0.0;
};
struct Row {
  std::vector<Apex> apexes;
  double deepest = -infinity;
};

std::vector<Row> rowsOf(const Image& tFocus, glm::ivec2 size, const Depths& depths, bool onSilhouette) {
  const auto meets = [&](glm::ivec2 pixel) {
    return !std::isnan(tFocus[static_cast<std::size_t>(pixel.y * size.x + pixel.x)]);
  };
  const auto isBeside = [&](glm::ivec2 pixel) {
    return glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, size)) &&
           !meets(pixel);
  };
  std::vector<Row> rows(static_cast<std::size_t>(size.y));
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const glm::ivec2 pixel(i, j), right(1, 0), down(0, 1);
      if (!meets(pixel)) continue;
      if (onSilhouette && !isBeside(pixel + right) && !isBeside(pixel - right) && !isBeside(pixel + down) &&
          !isBeside(pixel - down))
        continue;
      Row& row = rows[static_cast<std::size_t>(j)];
      row.apexes.push_back({i, tFocus[static_cast<std::size_t>(j * size.x + i)] * depths.perTime(pixel)});
      row.deepest = std::max(row.deepest, row.apexes.back().depth);
    }
  return rows;
}

}  // namespace

Image coneStart(const HitPoints& hits, const Camera& camera, glm::ivec2 size, double slope, bool onSilhouette) {
  const Depths depths(camera, size);
  const std::vector<Row> rows = rowsOf(hits.tFocus, size, depths, onSilhouette);
  const double fallPerPixel = slope * depths.pitch();
  const auto depthOfCone = [&](double apex, double pixels) {
    const double fall = fallPerPixel * pixels;
    return depths.perspective() ? apex / (1.0 + fall) : apex - fall;
  };
  const auto deepestAt = [&](glm::ivec2 pixel) {
    double deepest = -infinity;
    // Rows outwards from the pixel's own; a row whose deepest apex could not do more from straight above is left out.
    for (int k = 0; k < 2 * size.y; ++k) {
      const int away = (k + 1) / 2, j = pixel.y + (k % 2 ? away : -away);
      if (j < 0 || j >= size.y) continue;
      const Row& row = rows[static_cast<std::size_t>(j)];
      if (row.apexes.empty() || depthOfCone(row.deepest, away) <= deepest) continue;
      for (const Apex& apex : row.apexes)
        deepest = std::max(deepest, depthOfCone(apex.depth, std::hypot(apex.x - pixel.x, away)));
    }
    return deepest;
  };
  Image start(hits.tContext.size(), unknown);
  parallelFor(start.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      interruptionPoint();
      const double context = hits.tContext[i];
      if (std::isnan(context)) continue;
      const glm::ivec2 pixel(static_cast<int>(i) % size.x, static_cast<int>(i) / size.x);
      const double wanted = std::isnan(hits.tFocus[i]) ? deepestAt(pixel) / depths.perTime(pixel) : hits.tFocus[i];
      start[i] = std::clamp(wanted, context, std::max(context, hits.tOut[i]));
    }
  });
  return start;
}

Image openedBy(const Stages& stages) {
  Image opened = stages.hits.tFocus;
  for (std::size_t i = 0; i < stages.tCones.size(); ++i)
    if (stages.tCones[i] > stages.hits.tContext[i]) opened[i] = stages.tCones[i];
  return opened;
}

}  // namespace fenestra::reference
