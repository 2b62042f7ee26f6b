#pragma once
// Scenes of a distance field whose zero level has known principal curvatures, around labels that put the context layer
// over it.

#include <functional>

#include "tests/support/Scenes.h"

namespace fenestra::tests {

struct KnownShape {
  Scene scene;
  glm::dvec3 centre{0.0};
  double extent = 1.0;  ///< mm: of the part that is looked at
  /// κ1 ≥ κ2 (1/mm) of the level set through a world point.
  std::function<glm::dvec2(glm::dvec3)> curvaturesAt;

  Camera camera() const {
    const glm::dvec3 from = glm::normalize(glm::dvec3(0.3, -1.0, 0.2));
    return lookAt(centre + 10.0 * extent * from, centre, Projection::Orthographic, extent);
  }
};

/// `distance` (mm, negative inside, relative to the centre) on a grid of 1 mm voxels `half` to every side; labels where
/// it is below `labelled`.
inline KnownShape knownShape(int half, const std::function<double(glm::dvec3)>& distance, double labelled) {
  KnownShape shape;
  const Grid grid = gridOf(glm::ivec3(2 * half + 1));
  shape.centre = glm::dvec3(half);
  const auto at = [&](glm::ivec3 i) { return distance(glm::dvec3(i) - shape.centre); };
  shape.scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return -at(i); });
  shape.scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return at(i) < labelled; });
  shape.scene.look.focus = LabelFocus{{1}};
  shape.scene.look.context.function = opaqueFrom(0.0);
  return shape;
}

inline KnownShape sphere(double radius) {
  KnownShape shape = knownShape(
      static_cast<int>(radius) + 6, [=](glm::dvec3 p) { return glm::length(p) - radius; }, -1.5);
  shape.extent = radius;
  const glm::dvec3 centre = shape.centre;
  shape.curvaturesAt = [=](glm::dvec3 p) { return glm::dvec2(1.0 / glm::distance(p, centre)); };
  return shape;
}

/// Along z; seen from outside, or, hollow, its inside wall bends away from the viewer.
inline KnownShape cylinder(double radius, bool solid) {
  const double sign = solid ? 1.0 : -1.0;
  KnownShape shape = knownShape(
      static_cast<int>(radius) + 6,
      [=](glm::dvec3 p) {
        // The near half of a hollow one is left out, to look inside.
        if (!solid && p.y < 0.0) return radius - std::hypot(p.x, 0.0);
        return sign * (std::hypot(p.x, p.y) - radius);
      },
      -1.5);
  shape.extent = radius;
  const glm::dvec3 centre = shape.centre;
  shape.curvaturesAt = [=](glm::dvec3 p) {
    const double k = sign / std::hypot(p.x - centre.x, p.y - centre.y);
    return glm::dvec2(std::max(k, 0.0), std::min(k, 0.0));
  };
  return shape;
}

/// In the x–y plane. On the tube 1/r across, and along cos θ / (R + r cos θ): positive outside, negative inside.
inline KnownShape torus(double ring, double tube) {
  KnownShape shape = knownShape(
      static_cast<int>(ring + tube) + 6,
      [=](glm::dvec3 p) { return std::hypot(std::hypot(p.x, p.y) - ring, p.z) - tube; }, -1.5);
  shape.extent = 2.0 * (ring + tube);
  const glm::dvec3 centre = shape.centre;
  shape.curvaturesAt = [=](glm::dvec3 p) {
    const double axis = std::hypot(p.x - centre.x, p.y - centre.y), out = axis - ring;
    const double along = out / std::hypot(out, p.z - centre.z) / axis;
    const double across = 1.0 / std::hypot(out, p.z - centre.z);
    return glm::dvec2(std::max(across, along), std::min(across, along));
  };
  return shape;
}

}  // namespace fenestra::tests
