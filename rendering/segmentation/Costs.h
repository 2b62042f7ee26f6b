#pragma once
// What a voxel costs: how far its value lies from the seeds'.

#include <array>
#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// Costs in units of the noise: the distance to the seeds' tones, where values between two of them belong too.
class TissueCost {
 public:
  /// `tones` are the seeds'; there is one at least.
  explicit TissueCost(std::span<const float> tones);

  float operator()(float tone) const;
  /// Tabulated, because a logarithm a voxel would take longer than the flood.
  Level levelOf(float cost) const {
    return cost < limit ? table_[static_cast<std::size_t>(cost * perUnit + 0.5f)] : never;
  }

 private:
  static constexpr float perUnit = 128.0f, limit = 64.0f;  // 64 units are beyond the last level
  float darkest_, brightest_;
  std::array<Level, static_cast<std::size_t>(perUnit* limit) + 1> table_{};
};

/// Smoothed tones of a box and of its face neighbours, and the levels of their costs with sharp edges.
///
/// A voxel on an edge holds two tissues. Its value lies between theirs and is a cost of neither; a tolerance would take
/// such voxels in one by one. So a voxel takes the cost of the cheapest or of the dearest of its face neighbours and
/// itself, whichever has the nearer value, where the two differ by more than noise does: Kramer, Bruckner, "Iterations
/// of a non-linear transformation for enhancement of digital images", Pattern Recognition 7, 1975, with neighbours
/// ordered by cost. An edge then lies where a voxel holds more of the one tissue than of the other.
class EdgeSharpener {
 public:
  /// Both outlive this.
  EdgeSharpener(const Volume& volume, const ToneScale& scale);

  /// The box that forRows() visits. Boxes of one size share their memory.
  void read(const VoxelBox& box);

  /// visit(y, z, levels of the row), for all rows of the box.
  template <class Visit>
  void forRows(const TissueCost& cost, Visit visit) {
    for (std::size_t i = 0; i < tones_.size(); ++i) costs_[i] = cost(tones_[i]);
    for (int z = box_.low.z; z < box_.high.z; ++z)
      for (int y = box_.low.y; y < box_.high.y; ++y) {
        sharpenRow(y, z);
        for (std::size_t x = 0; x < row_.size(); ++x) levels_[x] = cost.levelOf(row_[x]);
        visit(y, z, std::span<const Level>(levels_));
      }
  }

 private:
  void sharpenRow(int y, int z);

  const ToneScale& scale_;
  ToneSmoother smooth_;
  VoxelBox box_, read_;
  float leastEdge_;               ///< units of the noise
  std::span<const float> tones_;  ///< of read_
  std::vector<float> values_;     ///< of read_; tones without the display window's
  std::vector<float> costs_;      ///< of read_
  std::vector<float> row_;        ///< sharpened costs
  std::vector<Level> levels_;
};

}  // namespace fenestra::segmentation
