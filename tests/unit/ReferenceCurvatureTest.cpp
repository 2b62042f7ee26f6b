// The context layer's curvatures on surfaces whose κ1 and κ2 are known, at several radii in voxels.

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "tests/support/Shapes.h"

namespace fenestra::reference::referenceCurvatureTest {
namespace {

using namespace tests;

/// Greatest error of κ1 and κ2 over a shape's visible surface, in units of its sharpest curvature.
double worstError(const KnownShape& shape) {
  const Camera camera = shape.camera();
  const glm::ivec2 size(24, 24);
  const Stages stages = geometricStages(shape.scene, camera, size);
  const Picture result = picture(shape.scene, camera, size, stages);
  double worst = 0.0;
  int seen = 0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const auto at = static_cast<std::size_t>(j * size.x + i);
      if (std::isnan(result.contextLayer[at].x)) continue;
      const Ray ray = pixelRay(camera, size, {i, j});
      const glm::dvec2 exact = shape.curvaturesAt(ray.origin + stages.hits.tContext[at] * ray.direction);
      const glm::dvec2 found(result.contextLayer[at]);
      const double scale = std::max(std::abs(exact.x), std::abs(exact.y));
      worst = std::max({worst, std::abs(found.x - exact.x) / scale, std::abs(found.y - exact.y) / scale});
      ++seen;
    }
  EXPECT_GT(seen, 50);
  return worst;
}

// Second derivatives of a cubic spline are linear between its elements, here 2 mm apart: they are off by a fourth
// derivative times the spacing squared, and curvature by a share of the order of (spacing / radius)². Measured, it is
// 0.9 to 1.05 of (1 mm / radius)² from radii of 6 mm on.
double allowedAt(double radius) { return 1.2 / (radius * radius); }

TEST(ReferenceCurvature, ofSpheres) {
  for (const double radius : {4.0, 6.0, 8.0, 12.0}) EXPECT_LE(worstError(sphere(radius)), allowedAt(radius)) << radius;
}

TEST(ReferenceCurvature, ofCylindersFromOutsideAndInside) {
  for (const bool solid : {true, false})
    for (const double radius : {4.0, 6.0, 8.0, 12.0})
      EXPECT_LE(worstError(cylinder(radius, solid)), allowedAt(radius)) << radius;
}

TEST(ReferenceCurvature, ofTori) {
  for (const double tube : {4.0, 6.0, 8.0}) EXPECT_LE(worstError(torus(2.0 * tube, tube)), allowedAt(tube)) << tube;
}

}  // namespace
}  // namespace fenestra::reference::referenceCurvatureTest
