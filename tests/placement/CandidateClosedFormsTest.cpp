// Candidates as the GPU measures them, against closed forms.

#include <iostream>

#include "tests/placement/CandidateTesting.h"

namespace fenestra::placement::candidateClosedFormsTest {
namespace {

/// Largest error of an area, the sum of three: chords cut 2π/12 of a square pixel off a convex outline (∮κ ds = 2π, a
/// chord's segment is κ/12 of its length cubed); each crossing has an independent error of up to 1/32 of a pixel, taken
/// at three standard deviations; and trilinear interpolation moves a curved surface inwards.
double areaError(double outlinePixels, double fieldError) {
  return 0.53 + 3.0 / 32.0 / std::sqrt(3.0) * std::sqrt(outlinePixels) + fieldError * outlinePixels;
}

TEST_F(CandidateTest, ABallInClosedForm) {
  const Grid grid = gridOf({64, 60, 56});
  const glm::dvec3 centre(28.3, 33.1, 26.4);
  const double r = 13.0, radius = grid.boundingRadius();
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return r - glm::length(glm::dvec3(i) - centre); }, 0.0);
  const glm::dvec3 offset = centre - grid.centre();
  const double perPixel = 2.0 * radius / 128.0;
  for (const Candidate& candidate : measure(scene, ringDirections(3), 128)) {
    const double expected = pi * r * r / (perPixel * perPixel);
    // Trilinear interpolation of a distance errs by (1/8)·(2/r) of a squared voxel.
    EXPECT_NEAR(candidate.sums.count, expected, areaError(2.0 * pi * r / perPixel, 0.25 / r / perPixel));
    // The mean height of a half sphere over its disc is 2/3 of its radius. Half a pixel of outline, seen edge on.
    const double depth = 0.5 + (-glm::dot(offset, candidate.direction) - 2.0 / 3.0 * r) / (2.0 * radius);
    EXPECT_NEAR(candidate.descriptors.visibility, depth, 0.05 * perPixel / (2.0 * radius));
    const Camera::Axes axes = axesAt(candidate.direction);
    const glm::dvec2 position = glm::dvec2(glm::dot(offset, axes.right), glm::dot(offset, axes.up)) / radius;
    EXPECT_NEAR(candidate.descriptors.location, 1.0 - glm::length(position) / std::sqrt(2.0), 0.03 * perPixel / radius);
  }
}

TEST_F(CandidateTest, AnEllipsoidInClosedForm) {
  const Grid grid = gridOf({60, 60, 60});
  const glm::dvec3 centre(30.2, 28.7, 31.1), axes(22.0, 14.0, 9.0);
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return 1.0 - glm::length((glm::dvec3(i) - centre) / axes); }, 0.0);
  const double perPixel = 2.0 * grid.boundingRadius() / 128.0;
  for (const Candidate& candidate : measure(scene, ringDirections(3), 128)) {
    const glm::dvec3 shadow = candidate.direction * glm::dvec3(axes.y * axes.z, axes.x * axes.z, axes.x * axes.y);
    const double area = pi * glm::length(shadow);
    // The outline is shorter than that of the enclosing circle; the surface is most curved at the ends of the long
    // axis.
    EXPECT_NEAR(candidate.sums.count, area / (perPixel * perPixel),
                areaError(2.0 * pi * axes.x / perPixel, 0.05 / perPixel));
  }
}

TEST_F(CandidateTest, ASlabInClosedForm) {
  const Grid grid = gridOf({60, 60, 60});
  const glm::ivec3 low(10, 22, 31), size(36, 20, 8);
  const Scene scene = labelScene(grid, [&](glm::ivec3 i) {
    return glm::all(glm::greaterThanEqual(i, low)) && glm::all(glm::lessThan(i, low + size)) ? 1 : 0;
  });
  const double perPixel = 2.0 * grid.boundingRadius() / 128.0;
  for (const Candidate& candidate : measure(scene, ringDirections(3), 128)) {
    const glm::dvec3 d = glm::abs(candidate.direction), s(size);
    const double area = d.x * s.y * s.z + d.y * s.x * s.z + d.z * s.x * s.y;
    const double outline = 2.0 * (s.x + s.y + s.z);
    // The 0.5 level lies half way between voxels; it takes √2·(√½ - ½) = 0.29 of a voxel off the edges.
    EXPECT_NEAR(candidate.sums.count, area / (perPixel * perPixel), areaError(outline / perPixel, 0.29 / perPixel));
  }
}

TEST_F(CandidateTest, TwoBallsHideOneAnotherAlongTheirAxis) {
  const Grid grid = gridOf({70, 40, 40});
  const double r = 8.0;
  const glm::dvec3 a(18.5, 19.5, 19.5), b(50.5, 19.5, 19.5);
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return r - std::min(glm::length(glm::dvec3(i) - a), glm::length(glm::dvec3(i) - b)); },
      0.0);
  const double perPixel = 2.0 * grid.boundingRadius() / 128.0, disc = pi * r * r / (perPixel * perPixel);
  const std::vector<Candidate> candidates = measure(scene, {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, 128, 2000);
  const double tolerance = areaError(4.0 * pi * r / perPixel, 0.25 / r / perPixel);
  EXPECT_NEAR(candidates[0].sums.count, disc, tolerance);
  EXPECT_NEAR(candidates[1].sums.count, 2.0 * disc, tolerance);
  EXPECT_NEAR(candidates[2].sums.count, 2.0 * disc, tolerance);
  // A quarter of the surface is seen along the axis, half of it from the side. The hidden ball has the front ball's
  // outline: points within 15 degrees of edge-on there (a quarter of the quarter) may count as seen or not.
  EXPECT_NEAR(seenShare(candidates[0], candidates[0], surface().points.size()), 0.25, 0.06);
  EXPECT_NEAR(seenShare(candidates[1], candidates[1], surface().points.size()), 0.5, 0.02);
}

TEST_F(CandidateTest, ASmallBallBehindALargerOneIsHidden) {
  const Grid grid = gridOf({70, 40, 40});
  const glm::dvec3 large(18.5, 19.5, 19.5), small(50.5, 19.5, 19.5);
  const auto inside = [&](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - large) < 10.0 || glm::length(glm::dvec3(i) - small) < 6.0;
  };
  const std::vector<Candidate> candidates =
      measure(labelScene(grid, [&](glm::ivec3 i) { return inside(i) ? 1 : 0; }), {{-1, 0, 0}, {1, 0, 0}}, side, 2000);
  const double all = 10.0 * 10.0 + 6.0 * 6.0;
  // From the large ball's side half of that is seen; from the other side half of the small one and the ring of the
  // large one around it.
  const auto share = [&](std::size_t i) { return seenShare(candidates[i], candidates[i], surface().points.size()); };
  // Normals err by up to two degrees, which puts at most 2π/90 of a half's 2π on the wrong side of the outline.
  EXPECT_NEAR(share(0), 0.5 * 10.0 * 10.0 / all, 0.015);
  const double ring = 10.0 * 10.0 * (1.0 - (1.0 - std::sqrt(1.0 - 0.36)));
  EXPECT_NEAR(share(1), 0.5 * (6.0 * 6.0 + ring) / all, 0.015);
}

TEST_F(CandidateTest, ABallsSurfaceAndWhatIsSeenOfIt) {
  for (const Grid& grid : {gridOf({48, 48, 48}), gridOf({60, 50, 24}, {0.7, 0.9, 1.8}), shearedGrid({60, 40, 28})}) {
    const double r = 14.0;
    const glm::dmat4 world = grid.worldFromIndex();
    const glm::dvec3 centre = grid.centre();
    const Scene scene = labelScene(
        grid, [&](glm::ivec3 i) { return glm::length(glm::dvec3(world * glm::dvec4(i, 1.0)) - centre) < r ? 1 : 0; });
    std::vector<glm::dvec3> directions;
    for (const glm::dvec3 direction : ringDirections(1)) {
      directions.push_back(direction);
      directions.push_back(-direction);
    }
    const std::vector<Candidate> candidates = measure(scene, directions, side, 4096);
    // Errors of the normals enter in second order: 5 degrees are 0.4 %.
    EXPECT_NEAR(surface().area / (4.0 * pi * r * r), 1.0, 0.01);
    ASSERT_NEAR(static_cast<double>(surface().points.size()), 4096.0, 1.0);
    for (std::size_t i = 0; i < candidates.size(); i += 2) {
      const std::size_t points = surface().points.size();
      // Normals err by up to two degrees, and so does the boundary of the far half.
      EXPECT_NEAR(seenShare(candidates[i], candidates[i], points), 0.5, 0.015);
      // Half of the points that are exactly edge-on, some four in a hundred, count as seen: the same half from both
      // sides.
      EXPECT_NEAR(seenShare(candidates[i], candidates[i + 1], points), 1.0, 0.025);
    }
  }
}

TEST_F(CandidateTest, PointsOfASmoothedBallLieNearerToIt) {
  const Grid grid = gridOf({48, 48, 48});
  const double r = 14.0;
  Scene scene = labelScene(grid, [&](glm::ivec3 i) { return glm::length(glm::dvec3(i) - grid.centre()) < r ? 1 : 0; });
  const auto rmsDistance = [&] {
    const std::vector<Candidate> candidates = measure(scene, {{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}}, side, 4096);
    double sum = 0.0;
    for (const FocusSurface::Point& point : surface().points)
      sum += std::pow(glm::distance(point.index, grid.centre()) - r, 2.0);
    // Both halves are seen, as of the ball with steps.
    EXPECT_NEAR(seenShare(candidates[0], candidates[1], surface().points.size()), 1.0, 0.025);
    return std::sqrt(sum / static_cast<double>(surface().points.size()));
  };
  const double exact = rmsDistance();
  scene.look.labelSmoothing = LabelSmoothing::Light;
  const double smoothed = rmsDistance();
  std::cout << "points are " << exact << " voxels from the ball, smoothed " << smoothed << '\n';
  EXPECT_LT(smoothed, 0.6 * exact);
}

TEST_F(CandidateTest, ABoxsSurface) {
  const Grid grid = gridOf({40, 40, 40}, {0.8, 1.0, 1.3});
  const Scene scene = labelScene(grid, [&](glm::ivec3 i) {
    return i.x >= 8 && i.x < 32 && i.y >= 10 && i.y < 30 && i.z >= 9 && i.z < 31 ? 1 : 0;
  });
  measure(scene, {{1, 0, 0}}, side, 1000);
  const glm::dvec3 s(24 * 0.8, 20 * 1.0, 22 * 1.3);
  // Edges are rounded over two of twenty voxels: a quarter circle in place of two sides.
  EXPECT_NEAR(surface().area / (2.0 * (s.x * s.y + s.y * s.z + s.x * s.z)), 1.0, 0.04);
  for (const FocusSurface::Point& point : surface().points) EXPECT_NEAR(glm::length(point.normal), 1.0, 1e-12);
}

}  // namespace
}  // namespace fenestra::placement::candidateClosedFormsTest
