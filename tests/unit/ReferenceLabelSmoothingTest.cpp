// The reference of smoothed label surfaces: its hits and the normals of its light.

#include <array>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "rendering/reference/Light.h"
#include "rendering/reference/Reference.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceLabelSmoothingTest {
namespace {

using namespace tests;

const Grid grid = gridOf(glm::ivec3(52));
const glm::dvec3 middle(25.3, 25.6, 26.1), upwards = glm::normalize(glm::dvec3(-1.0, -2.0, 13.0));

/// Labels below a slope of terraces.
Scene slope(LabelSmoothing smoothing) {
  Scene scene;
  scene.volume = volumeOf(grid, [](glm::ivec3) { return 0.0; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return glm::dot(glm::dvec3(i) - middle, upwards) < 0.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(100.0);
  scene.look.labelSmoothing = smoothing;
  return scene;
}

/// From above, on the part of the slope away from the volume's border.
Camera above() {
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.eye = middle + glm::dvec3(0.0, 0.0, 100.0);
  camera.target = middle;
  camera.up = {0.0, 1.0, 0.0};
  camera.orthographicHeight = 24.0;
  return camera;
}

TEST(ReferenceLabelSmoothing, HitsOfASlopeAndItsNormalsAreNearerToTheTruth) {
  constexpr glm::ivec2 size(60);
  std::array<double, 3> distances{}, angles{};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const Scene scene = slope(static_cast<LabelSmoothing>(i));
    const HitPoints hits = hitPoints(scene, above(), size);
    const FocusNormals normals(grid, FocusField(scene));
    double squares = 0.0, sum = 0.0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const Ray ray = pixelRay(above(), size, {x, y});
        const double t = hits.tFocus[static_cast<std::size_t>(x + size.x * y)];
        ASSERT_TRUE(std::isfinite(t));
        const glm::dvec3 hit = ray.origin + t * ray.direction;
        squares += std::pow(glm::dot(hit - middle, upwards), 2.0);
        const double cosine = -glm::dot(glm::normalize(normals.at(hit)), upwards);
        sum += glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
      }
    distances[i] = std::sqrt(squares / (size.x * size.y));
    angles[i] = sum / (size.x * size.y);
    std::cout << "strength " << i << ": hits " << distances[i] << " voxels RMS from the slope, lit normals off by "
              << angles[i] << "°\n";
  }
  EXPECT_LT(distances[1], 0.6 * distances[0]);
  EXPECT_LT(distances[2], 0.3 * distances[0]);
  EXPECT_LT(angles[1], angles[0]);
  EXPECT_LT(angles[2], 0.5 * angles[0]);
}

}  // namespace
}  // namespace fenestra::reference::referenceLabelSmoothingTest
