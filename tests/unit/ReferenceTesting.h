#pragma once
// Scenes of one ray, whose picture has a closed form, and a rough one.

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference {

using namespace tests;

const glm::dvec3 red(0.9, 0.2, 0.1), blue(0.1, 0.3, 0.8);

/// Unlit values along x without a focus.
template <class F>
Scene profile(int count, F&& valueAt, TransferFunction transfer, double spacing = 1.0) {
  Scene scene;
  scene.volume = volumeOf(gridOf({count, 3, 3}, glm::dvec3(spacing)), [&](glm::ivec3 i) { return valueAt(i.x); });
  scene.look.context.function = std::move(transfer);
  scene.look.shading.enabled = false;
  return scene;
}

/// One ray along x through the middle of the grid.
inline Camera alongX(const Grid& grid) {
  const glm::dvec3 centre = grid.centre();
  return lookAt(centre - glm::dvec3(100.0, 0.0, 0.0), centre, Projection::Orthographic, 1.0);
}

inline glm::dvec4 onePixel(const Scene& scene, double tolerance) {
  PictureOptions options;
  options.tolerance = tolerance;
  const Picture result = picture(scene, alongX(scene.volume->grid), {1, 1}, options);
  EXPECT_LE(result.error[0], tolerance);
  return result.focusLayer[0];
}

inline void expectNear(glm::dvec4 found, glm::dvec4 expected, double tolerance) {
  for (int channel = 0; channel < 4; ++channel) EXPECT_NEAR(found[channel], expected[channel], tolerance) << channel;
}

/// Noise with gradients, a curved transfer function and a focus: every feature of an integrand.
inline Scene roughScene() {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  const Grid grid = obliqueGrid({14, 12, 10});
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3) { return value(random); });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i.x > 8 && i.y > 3 ? (i.z < 5 ? 1 : 2) : 0; });
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.focusAppearance.extinction = 0.4;
  scene.look.context.function = {{{0.2, {red, 0.0}}, {0.5, {blue, 0.3}}, {0.5, {red, 0.05}}, {0.9, {red, 2.0}}}};
  scene.look.cutaway.openWidth = 8.0;
  return scene;
}

}  // namespace fenestra::reference
