#include "rendering/segmentation/Smoothing.h"

#include <algorithm>
#include <cmath>

namespace fenestra::segmentation {
namespace {

/// ε of the guided filter in variances of the noise. Between 1 and 4 the regions hardly change; 8 blurs thin
/// structures.
constexpr float flatness = 3.0f;

/// The window that CT is read with first. Not the file's own: the region must not depend on who wrote the file.
constexpr WindowLevel softTissue{400.0, 40.0};
/// Share of a display window that the eye tells apart in a texture.
constexpr double seenShare = 0.02;

/// Real value of a stored one, finite.
template <class T>
double finiteValue(T stored, const Volume& volume) {
  const double real = volume.slope * static_cast<double>(stored) + volume.intercept;
  if constexpr (std::is_floating_point_v<T>)
    return std::isnan(real) ? volume.range.low : std::clamp(real, volume.range.low, volume.range.high);
  return real;
}

/// Numbers on a small grid, x fastest.
struct Block {
  glm::ivec3 dims;
  std::vector<float> values;

  explicit Block(glm::ivec3 size) : dims(size), values(VoxelBox{glm::ivec3(0), size}.count()) {}
};

/// Sums of three neighbours along an axis, whose side shrinks by two.
Block sumsAlong(const Block& from, int axis) {
  glm::ivec3 dims = from.dims;
  dims[axis] -= 2;
  Block to(dims);
  const std::size_t strides[3] = {1, static_cast<std::size_t>(from.dims.x),
                                  static_cast<std::size_t>(from.dims.x) * static_cast<std::size_t>(from.dims.y)};
  const std::size_t step = strides[axis];
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) {
      const float* row =
          from.values.data() + static_cast<std::size_t>(y) * strides[1] + static_cast<std::size_t>(z) * strides[2];
      float* sums = to.values.data() + VoxelBox{glm::ivec3(0), dims}.offset({0, y, z});
      for (std::size_t x = 0; x < static_cast<std::size_t>(dims.x); ++x)
        sums[x] = row[x] + row[x + step] + row[x + 2 * step];
    }
  return to;
}

/// Mean of 3×3×3; each side shrinks by two.
Block means(const Block& from) {
  Block to = sumsAlong(sumsAlong(sumsAlong(from, 0), 1), 2);
  for (float& value : to.values) value *= 1.0f / 27.0f;
  return to;
}

/// The voxels of `box`, which may reach beyond the volume: its edge is repeated there.
template <class T>
Block tonesOf(std::span<const T> scalars, const Volume& volume, const VoxelBox& box, const ToneScale& scale) {
  Block block(box.dims());
  const glm::ivec3 last = volume.grid.dims - 1;
  float* to = block.values.data();
  for (int z = box.low.z; z < box.high.z; ++z)
    for (int y = box.low.y; y < box.high.y; ++y) {
      const T* row = scalars.data() + volume.grid.offset({0, std::clamp(y, 0, last.y), std::clamp(z, 0, last.z)});
      for (int x = box.low.x; x < box.high.x; ++x)
        *to++ = static_cast<float>(scale(finiteValue(row[std::clamp(x, 0, last.x)], volume)));
    }
  return block;
}

}  // namespace

ToneScale::ToneScale(const Volume& volume, const Noise& noise, double reference) : noise_(noise) {
  if (volume.isInHounsfieldUnits())
    seen_ = {softTissue.level - 0.5 * softTissue.width, softTissue.level + 0.5 * softTissue.width};
  reference_ = toned(std::isfinite(reference) ? reference : volume.range.low);
  seenTones_ = {static_cast<float>((*this)(seen_.low)), static_cast<float>((*this)(seen_.high))};
}

Noise noiseOf(const Volume& volume) {
  const glm::ivec3 dims = volume.grid.dims;
  const double width = volume.isInHounsfieldUnits() ? softTissue.width : volume.defaultWindow().width;
  const double least = seenShare * width;
  std::vector<float> differences;
  volume.voxels.visit([&](auto scalars) {
    // About half a million voxels are enough for a median.
    const std::size_t rows = static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z);
    const std::size_t stride = std::max<std::size_t>(1, scalars.size() / 500'000);
    for (std::size_t row = 0; row < rows; row += stride) {
      const auto* at = scalars.data() + row * static_cast<std::size_t>(dims.x);
      for (int x = 1; x + 1 < dims.x; ++x) {
        const double second =
            finiteValue(at[x], volume) - 0.5 * (finiteValue(at[x - 1], volume) + finiteValue(at[x + 1], volume));
        if (second != 0.0 || finiteValue(at[x], volume) != volume.range.low)
          differences.push_back(static_cast<float>(std::abs(second)));
      }
    }
  });
  if (differences.empty()) return {0.0, least};
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  // The median of a normal deviate's magnitude is 0.6745 σ; the difference has variance 1.5 σ².
  const double deviation = *middle / 0.6745 / std::sqrt(1.5);
  return {deviation, std::max(least, deviation)};
}

std::vector<float> smoothedTones(const Volume& volume, const VoxelBox& box, const ToneScale& scale) {
  const VoxelBox read = box.grownBy(glm::ivec3(2));
  const Block values = volume.voxels.visit([&](auto scalars) { return tonesOf(scalars, volume, read, scale); });
  Block squares(values.dims);
  std::transform(values.values.begin(), values.values.end(), squares.values.begin(), [](float v) { return v * v; });
  // q = a v + b with a = σ² / (σ² + ε) and b = (1 - a) v̄, both averaged over the windows that hold the voxel. A volume
  // without noise needs no smoothing; ε keeps the quotient finite there.
  const auto share = static_cast<float>(scale.noise().share());
  const float epsilon = std::max(1e-3f, flatness * share * share);
  Block slope = means(squares), intercept = means(values);
  for (std::size_t i = 0; i < slope.values.size(); ++i) {
    const float mean = intercept.values[i], variance = std::max(0.0f, slope.values[i] - mean * mean);
    slope.values[i] = variance / (variance + epsilon);
    intercept.values[i] = (1.0f - slope.values[i]) * mean;
  }
  slope = means(slope);
  intercept = means(intercept);
  std::vector<float> smoothed(box.count());
  const VoxelBox all = wholeOf(values.dims);
  const glm::ivec3 dims = box.dims();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) {
      const std::size_t begin = wholeOf(dims).offset({0, y, z});
      const float* row = values.values.data() + all.offset({2, y + 2, z + 2});
      for (std::size_t x = 0; x < static_cast<std::size_t>(dims.x); ++x)
        smoothed[begin + x] = slope.values[begin + x] * row[x] + intercept.values[begin + x];
    }
  return smoothed;
}

}  // namespace fenestra::segmentation
