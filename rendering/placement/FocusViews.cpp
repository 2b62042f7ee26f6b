#include "rendering/placement/FocusViews.h"

#include <algorithm>

namespace fenestra::placement {
namespace {

SurfacePoints pointsOf(const FocusSurface& sampled, const Grid& grid, const Measured& measured) {
  SurfacePoints surface;
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  for (const FocusSurface::Point& point : sampled.points) {
    surface.positions.emplace_back(worldFromIndex * glm::dvec4(point.index, 1.0));
    surface.normals.push_back(point.normal);
  }
  surface.labels = measured.pointLabels;
  surface.area = sampled.area;
  return surface;
}

/// The sphere around the mean of the surface's points that holds them all.
struct Ball {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};
Ball ballAround(const std::vector<glm::dvec3>& points) {
  Ball ball;
  for (const glm::dvec3 point : points) ball.centre += point / static_cast<double>(points.size());
  for (const glm::dvec3 point : points) ball.radius = std::max(ball.radius, glm::distance(point, ball.centre));
  return ball;
}

}  // namespace

DescribedViews describeViews(GpuScene& gpu, const Scene& scene, const Measured& measured, const Sampling& sampling,
                             bool needsImages) {
  // Sampling is deterministic, so these are the points that the candidates' bits stand for.
  const FocusSurface sampled = sampleSurface(gpu.drawn(scene), gpu.focus(), sampling.surfacePoints);
  SurfacePoints surface = pointsOf(sampled, gpu.grid(), measured);
  const std::vector<Candidate> candidates(measured.candidates.begin(),
                                          measured.candidates.begin() + static_cast<std::ptrdiff_t>(measured.spread));
  std::vector<ImageMeasures> images;
  if (needsImages && !surface.positions.empty()) {
    CandidateImages measure;
    const Grid& grid = gpu.grid();
    const Ball ball = ballAround(surface.positions);
    const int side = CandidateImages::sideFor(gpu, sampling.side);
    const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, grid);
    for (const Candidate& candidate : candidates) {
      const double depth = -glm::dot(ball.centre - grid.centre(), candidate.direction);
      images.push_back(measuresOf(measure.image(gpu, candidate.direction, side, kept), depth - ball.radius,
                                  depth + ball.radius, 2.0 * grid.boundingRadius()));
    }
  }
  return {candidates, std::move(surface), std::move(images)};
}

}  // namespace fenestra::placement
