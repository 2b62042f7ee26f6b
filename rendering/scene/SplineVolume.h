#pragma once
// A volume's values between the voxels as a tricubic B-spline.
//
// f(x) = Σ c_i β(x - i), β the tensor product of cubic B-splines, c one coefficient a voxel and one more beyond each
// end of each axis. Reconstruction::Cubic: c is what makes f equal the values at all voxel centres (Unser, Aldroubi,
// Eden, "B-spline signal processing", IEEE TSP 1993); the fourth differences of c vanish at both ends of an axis (the
// "not-a-knot" condition), so that f is a polynomial of degree 3 exactly wherever the values are one, up to the
// outermost centres. An axis of three voxels takes the parabola through them, one of two the line.
// Reconstruction::Smooth: c is the values themselves, continued evenly beyond the ends. Reconstruction::Smoother: c is
// their mean along each axis with the binomial weights 1, 4, 6, 4, 1, so continued; an impulse then has a standard
// deviation of √(4/3) voxels instead of √(1/3). f is C² in each. In the half voxel between the outermost centres and
// the volume's border f goes on as it is at the centres' plane.
//
// The coefficients of hidden voxels become air, after the filter: near them f is then a mean of air and what is shown,
// with non-negative weights. Filtered after the voxels were hidden, f would overshoot beside that step.

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "rendering/scene/ShownVolume.h"
#include "rendering/volume/Threads.h"

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
  /// Coefficients beyond the ends of an axis go on evenly, or are those at the ends.
  enum class Ends { Even, Held };

  /// `shown` is Cubic, Smooth or Smoother. NaN counts as the volume's least value, ±Inf as the ends of its range. Runs
  /// on all cores, and takes 8 bytes a voxel. `ends` applies to Smooth and Smoother.
  explicit SplineVolume(const ShownVolume& shown, Ends ends = Ends::Even);

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
  glm::ivec3 size() const { return size_; }  ///< coefficients along each axis

 private:
  void filter(Reconstruction kind, Ends ends);
  void hide(const ShownVolume& shown);
  template <class Use>
  void around(glm::dvec3 index, Use&& use) const;

  glm::ivec3 dims_, size_;
  std::vector<double> coefficients_;  ///< x fastest, from index -1
  ValueRange range_;
};

/// Vectors at the voxels, and their B-spline (Reconstruction::Smooth, with Ends::Held) between them: no longer than the
/// longest of them.
class SplineVectors {
 public:
  /// at(index) is the vector of a voxel; called from all cores.
  template <class At>
  SplineVectors(glm::ivec3 dims, const At& at)
      : SplineVectors(dims, ByRows{}, [&](int y, int z, std::span<glm::dvec3> row) {
          for (int x = 0; x < dims.x; ++x) row[static_cast<std::size_t>(x)] = at(glm::ivec3(x, y, z));
        }) {}
  /// at(y, z, row) fills the row of the vectors of y and z, x by x.
  struct ByRows {};
  template <class At>
  SplineVectors(glm::ivec3 dims, ByRows, const At& at) {
    std::array<std::shared_ptr<Volume>, 3> parts;
    for (std::shared_ptr<Volume>& part : parts) {
      part = std::make_shared<Volume>();
      part->grid.dims = dims;
      part->voxels = Voxels(ScalarType::Float32, part->grid.voxelCount());
      part->range = {-1e30, 1e30};  // of finite vectors
    }
    parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<glm::dvec3> row(static_cast<std::size_t>(dims.x));
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
        for (int y = 0; y < dims.y; ++y) {
          at(y, z, std::span(row));
          for (int axis = 0; axis < 3; ++axis) {
            Volume& part = *parts[static_cast<std::size_t>(axis)];
            std::transform(row.begin(), row.end(), part.voxels.as<float>().data() + part.grid.offset({0, y, z}),
                           [axis](const glm::dvec3& vector) { return static_cast<float>(vector[axis]); });
          }
        }
    });
    for (std::shared_ptr<Volume>& part : parts) {
      ShownVolume shown{std::exchange(part, nullptr)};
      shown.reconstruction = Reconstruction::Smooth;
      parts_.emplace_back(shown, SplineVolume::Ends::Held);
    }
  }

  glm::dvec3 at(glm::dvec3 index) const {
    return {parts_[0].value(index), parts_[1].value(index), parts_[2].value(index)};
  }
  const SplineVolume& part(int axis) const { return parts_[static_cast<std::size_t>(axis)]; }

 private:
  std::vector<SplineVolume> parts_;  ///< by axis
};

}  // namespace fenestra
