#pragma once
// A spline at the refined voxels (rendering/gpu/RefinedVolume.h), row by row.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rendering/scene/SplineVolume.h"

namespace fenestra {

/// Evaluates f - h²/12 · f'', h = 1/factor, axis by axis: z for a plane, y for a row of it, x for the samples. Sums are
/// in one order on every processor, so that samples are the same to the bit.
class RefinedSampler {
 public:
  RefinedSampler(const SplineVolume& spline, int factor);

  /// Coefficients of x and y in the plane of a refined z.
  std::vector<double> plane(int z) const;
  /// Room for what a row is made of, kept from row to row.
  struct Room {
    std::array<std::vector<double>, 3> coefficients;
    std::vector<std::uint32_t> coded;
  };
  /// The samples at the refined x of a refined y of such a plane.
  void row(const std::vector<double>& plane, int y, Room& room, std::span<double> samples) const;
  /// Those samples as (sample - least) · scale, rounded, in 0 … 65535.
  void row(const std::vector<double>& plane, int y, Room& room, double least, double scale,
           std::span<std::uint16_t> stored) const;
  /// A normal's components in such planes of splines that are sampled alike, at the refined x from `low` on, as texels
  /// of RGB10A2, zero at 511/1023.
  void normals(const std::array<std::vector<double>, 3>& planes, int y, Room& room, int low,
               std::span<std::uint32_t> texels) const;

 private:
  /// Coefficients of x of a refined y of a plane.
  void join(const std::vector<double>& plane, int y, std::vector<double>& coefficients) const;
  /// use(x, step, count) for the refined x from `low` to `high`, of which count ones lie step apart from x on and take
  /// coefficients one behind the other.
  template <class Use>
  void forEachRun(int low, int high, const Use& use) const;

  /// What the refined voxels along an axis take of the four coefficients around each.
  class Taps {
   public:
    Taps(int count, int factor);
    /// The second of the four.
    int voxel(int k) const { return voxels_[place(k)]; }
    double weight(int k, std::size_t of) const { return weights_[of][place(k)]; }
    /// The weights of k, k + factor, …, one behind the other.
    std::array<const double*, 4> weightsFrom(int k) const {
      const std::size_t at = place(k);
      return {weights_[0].data() + at, weights_[1].data() + at, weights_[2].data() + at, weights_[3].data() + at};
    }
    /// Within [firstEven, endEven) the voxel of k + factor is the one behind that of k.
    int firstEven() const { return (factor_ - 1) / 2; }
    int endEven() const { return factor_ * (count_ - 1) + firstEven(); }

   private:
    std::size_t place(int k) const { return static_cast<std::size_t>(k % factor_ * count_ + k / factor_); }

    int count_, factor_;
    std::vector<int> voxels_;
    std::array<std::vector<double>, 4> weights_;
  };

  const SplineVolume& spline_;
  int factor_;
  Taps x_, y_, z_;
};

/// SplineVolume::gradient() at the voxels of a row, to the bit.
void voxelGradients(const SplineVolume& spline, int y, int z, std::span<glm::dvec3> gradients);

/// Sets ten bits of each texel from `shift` on to a component of a normal, RGB10A2, zero at 511/1023.
void setTenBits(std::span<const double> components, int shift, std::uint32_t* texels);

}  // namespace fenestra
