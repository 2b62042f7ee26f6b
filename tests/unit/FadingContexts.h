#pragma once
// Shared tests of the references of contexts that fade: the gradient they fade by, the focus they leave, and the
// tolerance they keep.

#include <algorithm>

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference {

/// Central differences at the voxels (values an index), one-sided at the volume's border, interpolated at a place in
/// the index frame.
inline glm::dvec3 gradientAt(const Volume& volume, glm::dvec3 at) {
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
    gradient[axis] = interpolated(volume.grid, at, [&](glm::ivec3 voxel) {
      glm::ivec3 low = voxel, high = voxel;
      low[axis] = std::max(low[axis] - 1, 0);
      high[axis] = std::min(high[axis] + 1, volume.grid.dims[axis] - 1);
      return (volume.value(high) - volume.value(low)) / (high[axis] - low[axis]);
    });
  return gradient;
}

/// Expects that a scene whose whole context fades shows its focus alone, more opaque than `opacity` somewhere.
inline void expectTheFocusAlone(const Scene& scene, const Camera& camera, glm::ivec2 size, double opacity) {
  const Picture here = picture(scene, camera, size);
  Scene alone = scene;
  alone.look.context.function.nodes = {{-10.0, {glm::dvec3(1.0), 0.0}}, {2000.0, {glm::dvec3(1.0), 0.0}}};
  alone.look.cutaway.enabled = false;
  const Picture focus = picture(alone, camera, size);
  double greatest = 0.0;
  for (std::size_t i = 0; i < here.final.size(); ++i) {
    // Two integrals of tolerance 1e-5 in each of four channels.
    EXPECT_LT(glm::distance(here.final[i], focus.final[i]), 4e-5) << i;
    greatest = std::max(greatest, here.final[i].a);
  }
  EXPECT_GT(greatest, opacity);
  EXPECT_TRUE(here.contextLayer.empty()) << "nothing is cut away";
}

/// The picture's error and its estimate, at several tolerances.
inline void expectErrorsWithinTheTolerance(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const Picture truth = picture(scene, camera, size, {.tolerance = 1e-9, .pixels = {}});
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const Picture here = picture(scene, camera, size, {.tolerance = tolerance, .pixels = {}});
    for (std::size_t i = 0; i < here.final.size(); ++i) {
      EXPECT_LE(here.error[i], tolerance);
      const glm::dvec4 off = glm::abs(here.final[i] - truth.final[i]);
      EXPECT_LE(std::max({off.r, off.g, off.b, off.a}), tolerance) << i;
    }
  }
}

}  // namespace fenestra::reference
