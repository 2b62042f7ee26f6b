#pragma once
// A volume's values between the voxels as a tricubic B-spline.
//
// f(x) = Σ c_i β(x - i), β the tensor product of cubic B-splines, c one coefficient a voxel and one more beyond each
// end of each axis. Reconstruction::Cubic: c is what makes f equal the values at all voxel centres (Unser, Aldroubi,
// Eden, "B-spline signal processing", IEEE TSP 1993); the fourth differences of c vanish at both ends of an axis (the
// "not-a-knot" condition), so that f is a polynomial of degree 3 exactly wherever the values are one, up to the
// outermost centres. An axis of three voxels takes the parabola through them, one of two the line.
// Reconstruction::Smooth: c is the values themselves, continued evenly beyond the ends. f is C² either way. In the half
// voxel between the outermost centres and the volume's border f goes on as it is at the centres' plane.
//
// Of hidden voxels the coefficients become air, after the filter: near them f is then a mean of air and what is shown,
// with non-negative weights. Filtered after the voxels were hidden, f would overshoot beside that step.

#include <vector>

#include "rendering/scene/ShownVolume.h"

namespace fenestra {

/// Cubic B-spline weights of the four coefficients around a position, t in 0..1 behind the second, and their first and
/// second derivatives by t.
struct SplineWeights {
  glm::dvec4 value, slope, bend;
  explicit SplineWeights(double t);
};

/// A position along an axis of `count` voxels, clamped to the outermost centres: the voxel before it, and t behind
/// that.
struct SplinePlace {
  int voxel = 0;
  double t = 0.0;
  SplinePlace(double index, int count);
};

class SplineVolume {
 public:
  /// `shown` is Cubic or Smooth. NaN counts as the volume's least value, ±Inf as the ends of its range. Runs on all
  /// cores, and takes 8 bytes a voxel.
  explicit SplineVolume(const ShownVolume& shown);

  glm::ivec3 dims() const { return dims_; }  ///< voxels
  /// f (real value) and its gradient by the index, at a continuous index position.
  double value(glm::dvec3 index) const;
  glm::dvec3 gradient(glm::dvec3 index) const;
  /// Least and greatest coefficient: f lies between them, in the cell from `cell` to `cell` + 1 (-1 … dims - 1 on each
  /// axis), or anywhere.
  ValueRange range(glm::ivec3 cell) const;
  const ValueRange& range() const { return range_; }

  /// Coefficients along x from index -1 on, for voxels y and z, -1 … dims.
  const double* row(int y, int z) const;
  int rowSize() const { return size_.x; }

 private:
  void filter(Reconstruction kind);
  void hide(const ShownVolume& shown);
  template <class Use>
  void around(glm::dvec3 index, Use&& use) const;

  glm::ivec3 dims_, size_;
  std::vector<double> coefficients_;  ///< x fastest, from index -1
  ValueRange range_;
};

}  // namespace fenestra
