#pragma once
// The lighting model of rendering/scene/Lighting.h in double precision.

#include "rendering/reference/FocusField.h"

namespace fenestra::reference {

/// The light of a view.
struct Light {
  Light(const Camera& camera, const Shading& shading);

  /// Towards the light, unit, world.
  glm::dvec3 direction;
  Shading shading;

  /// Ambient and diffuse light on a surface whose normal is at |cosine| to the light. `open`: the shares of
  /// ambient and of direct light that arrive (Occlusion.h).
  double incident(double cosine, glm::dvec2 open = glm::dvec2(1.0)) const {
    return shading.ambient * open.x + shading.diffuse * cosine * open.y;
  }
  /// Diffuse and specular light that a point with such a normal gives back, 0 to 1, its length as in shade().
  double intensity(glm::dvec3 normal, glm::dvec3 rayDirection) const;
  glm::dvec3 lit(glm::dvec3 colour, glm::dvec3 normal, glm::dvec3 rayDirection,
                 glm::dvec2 open = glm::dvec2(1.0)) const;
  /// The length of `normal` says how certain it is; 0 gives the light of a surface of average orientation.
  glm::dvec3 shade(glm::dvec3 colour, glm::dvec3 normal, glm::dvec3 rayDirection,
                   glm::dvec2 open = glm::dvec2(1.0)) const;
};

/// Hermite interpolation from 0 at `low` to 1 at `high`, clamped.
double smoothstep(double low, double high, double x);

/// The gated unit normals g·n of a volume's voxels (see Lighting.h); world space.
class VoxelNormals {
 public:
  explicit VoxelNormals(const Volume& volume);

  /// g·n of the voxel at `index` (inside the grid), from the values around it.
  template <class ValueAt>
  glm::dvec3 at(glm::ivec3 index, const ValueAt& valueAt) const {
    return gated(gradient(index, valueAt));
  }

  /// The gradient there by central differences, by the index.
  template <class ValueAt>
  glm::dvec3 gradient(glm::ivec3 index, const ValueAt& valueAt) const {
    glm::dvec3 difference(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 low = index, high = index;
      low[axis] = std::max(index[axis] - 1, 0);
      high[axis] = std::min(index[axis] + 1, dims_[axis] - 1);
      if (high[axis] > low[axis]) difference[axis] = (valueAt(high) - valueAt(low)) / (high[axis] - low[axis]);
    }
    return difference;
  }
  /// The world gradient, per mm, of one by the index.
  glm::dvec3 world(glm::dvec3 indexGradient) const { return worldFromIndexGradient_ * indexGradient; }

  /// The gated normal of any gradient by the index.
  glm::dvec3 gated(glm::dvec3 indexGradient) const;

 private:
  glm::ivec3 dims_;
  glm::dmat3 worldFromIndexGradient_;
  double gateUnit_;  ///< gradient at which the gate's argument is 1
};

/// Normals of a label focus: its indicator, itself smoothed or not, smoothed by (1 4 6 4 1)/16 twice along each axis (a
/// Gaussian of σ = √2 voxels), trilinear, differentiated over one voxel to either side.
class FocusNormals {
 public:
  /// Needs a focus of labels.
  FocusNormals(const Grid& grid, const FocusField& focus);

  /// World gradient at a continuous index position, per mm and not normalised; towards the inside.
  glm::dvec3 at(glm::dvec3 index) const;

 private:
  double smoothed(glm::dvec3 index) const;

  glm::dmat3 worldFromIndexGradient_;
  Grid box_;           ///< dims of field_
  glm::ivec3 low_{0};  ///< index of its first voxel; may lie outside the volume's grid, whose border is continued
  std::vector<float> field_;
};

}  // namespace fenestra::reference
