#include "rendering/segmentation/Curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>

#include "rendering/scene/Parallel.h"

namespace fenestra::segmentation {
namespace {

constexpr double largestRise = 6.0;  ///< noise units: a sharper edge is no better

// What a plateau must have. Chosen on half of the structures of tests/bench/results/growing.md; between a fall of 0.3
// and 1 the choice hardly matters.
constexpr double leastContrast = 1.2;  ///< noise units
constexpr double leastFall = 0.5;      ///< of the sharpness' logarithm, before a sharper surface follows
constexpr double leastVoxels = 50.0;   ///< fewer have no surface to speak of
constexpr double roundness = 3.0;      ///< how much a compact shape counts against a sharp edge
constexpr double plateauShare = 0.1;   ///< volumes within this share of the best one's are the same plateau

/// Sums by the level from which they count; accumulated over levels they are sums by step.
struct Sums {
  std::array<double, 257> voxels{}, area{}, rise{};

  void add(const Sums& other) {
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      voxels[i] += other.voxels[i];
      area[i] += other.area[i];
      rise[i] += other.rise[i];
    }
  }
};

class Counter {
 public:
  Counter(std::span<const Level> joins, std::span<const Level> costs, const Grid& grid, glm::ivec3 dims)
      : joins_(joins), costs_(costs), dims_(dims) {
    for (int level = 0; level < levelCount; ++level) cost_[static_cast<std::size_t>(level)] = costOf(level);
    cost_[never] = costOf(levelCount);
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 a = grid.direction[(axis + 1) % 3] * grid.spacing[(axis + 1) % 3];
      const glm::dvec3 b = grid.direction[(axis + 2) % 3] * grid.spacing[(axis + 2) % 3];
      faceArea_[axis] = glm::length(glm::cross(a, b));
    }
  }

  void count(int z, Sums& sums) const {
    const std::array<std::size_t, 3> steps{1, static_cast<std::size_t>(dims_.x),
                                           static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y)};
    std::size_t at = wholeOf(dims_).offset({0, 0, z});
    for (int y = 0; y < dims_.y; ++y)
      for (int x = 0; x < dims_.x; ++x, ++at) {
        if (joins_[at] != never) ++sums.voxels[joins_[at]];
        const glm::bvec3 last(x + 1 == dims_.x, y + 1 == dims_.y, z + 1 == dims_.z);
        for (int axis = 0; axis < 3; ++axis)
          if (!last[axis] && joins_[at] != joins_[at + steps[static_cast<std::size_t>(axis)]])
            face(at, at + steps[static_cast<std::size_t>(axis)], faceArea_[axis], sums);
      }
  }

 private:
  /// The face between two voxels is part of the surface from the level of the one until the other joins.
  void face(std::size_t a, std::size_t b, double area, Sums& sums) const {
    if (joins_[a] > joins_[b]) std::swap(a, b);
    const double rise = area * std::clamp(cost_[costs_[b]] - cost_[costs_[a]], -largestRise, largestRise);
    sums.area[joins_[a]] += area;
    sums.area[joins_[b]] -= area;
    sums.rise[joins_[a]] += rise;
    sums.rise[joins_[b]] -= rise;
  }

  std::span<const Level> joins_, costs_;
  glm::ivec3 dims_;
  std::array<double, 256> cost_{};
  glm::dvec3 faceArea_{0.0};
};

/// How sharp and how compact the surface at each step is, as a logarithm; leaks have ragged surfaces. -inf where there
/// is no region or no surface.
std::vector<double> sharpnessOf(const GrowthCurve& curve, double voxelVolume) {
  std::vector<double> sharpness(curve.volume.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t step = 0; step < sharpness.size(); ++step)
    if (curve.volume[step] >= leastVoxels * voxelVolume && curve.contrast[step] > 0.0)
      sharpness[step] = std::log(curve.contrast[step]) + roundness * std::log(curve.compactness[step]);
  return sharpness;
}

/// How far the sharpness falls after a step before it is exceeded; infinite when nothing sharper follows.
double fallAfter(const std::vector<double>& sharpness, std::size_t step) {
  double least = sharpness[step];
  for (std::size_t later = step + 1; later < sharpness.size(); ++later) {
    if (sharpness[later] > sharpness[step]) return sharpness[step] - least;
    least = std::min(least, sharpness[later]);
  }
  return std::numeric_limits<double>::infinity();
}

Plateau plateauAround(std::size_t best, const GrowthCurve& curve) {
  const double volume = curve.volume[best];
  std::size_t first = best, last = best;
  while (first > 1 && curve.volume[first - 1] >= (1.0 - plateauShare) * volume) --first;
  while (last + 1 < curve.volume.size() && curve.volume[last + 1] <= (1.0 + plateauShare) * volume) ++last;
  return {static_cast<int>(first), static_cast<int>(last), static_cast<int>(best), volume, curve.contrast[best]};
}

/// Local maxima of the sharpness on a contrast, before a fall; the first one is where to begin.
void findPlateaus(GrowthCurve& curve, double voxelVolume) {
  const std::vector<double> sharpness = sharpnessOf(curve, voxelVolume);
  for (std::size_t step = 1; step < sharpness.size(); ++step) {
    const bool peak = std::isfinite(sharpness[step]) && sharpness[step] > sharpness[step - 1] &&
                      (step + 1 == sharpness.size() || sharpness[step] >= sharpness[step + 1]);
    if (peak && curve.contrast[step] >= leastContrast && fallAfter(sharpness, step) >= leastFall)
      curve.plateaus.push_back(plateauAround(step, curve));
  }
  if (!curve.plateaus.empty()) {
    curve.automatic = curve.plateaus.front().best;
    return;
  }
  // Nothing stands out: the sharpest surface, or of regions too small for one, the least tolerance that has voxels.
  const auto sharpest = std::max_element(sharpness.begin(), sharpness.end());
  const auto any = std::find_if(curve.volume.begin(), curve.volume.end(), [](double volume) { return volume > 0.0; });
  curve.automatic = std::isfinite(*sharpest)    ? static_cast<int>(sharpest - sharpness.begin())
                    : any != curve.volume.end() ? static_cast<int>(any - curve.volume.begin())
                                                : 0;
}

}  // namespace

GrowthCurve growthCurve(std::span<const Level> joins, std::span<const Level> costs, const Grid& grid, glm::ivec3 dims) {
  const Counter counter(joins, costs, grid, dims);
  Sums sums;
  std::mutex mutex;
  parallelFor(static_cast<std::size_t>(dims.z), 4, [&](std::size_t begin, std::size_t end) {
    Sums local;
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z) counter.count(z, local);
    const std::scoped_lock lock(mutex);
    sums.add(local);
  });
  GrowthCurve curve;
  double voxels = 0.0, area = 0.0, rise = 0.0;
  for (int step = 0; step <= stepCount; ++step) {
    if (step > 0) {
      const auto level = static_cast<std::size_t>(step - 1);
      voxels += sums.voxels[level];
      area += sums.area[level];
      rise += sums.rise[level];
    }
    const double volume = voxels * grid.voxelVolume();
    curve.volume.push_back(volume);
    curve.contrast.push_back(area > 0.0 ? rise / area : 0.0);
    curve.compactness.push_back(area > 0.0 ? std::cbrt(36.0 * std::numbers::pi * volume * volume) / area : 0.0);
  }
  findPlateaus(curve, grid.voxelVolume());
  return curve;
}

}  // namespace fenestra::segmentation
