#include "rendering/segmentation/Smoothing.h"

#include <algorithm>
#include <cmath>

namespace fenestra::segmentation {
namespace {

/// ε of the guided filter in variances of the noise. Between 1 and 4 the regions hardly change; 8 blurs thin
/// structures.
constexpr float flatness = 3.0f;

/// The window that CT is read with first. Not the file's own: the region must not depend on who wrote the file.
constexpr WindowLevel softTissueWindow{400.0, 40.0};
/// Share of a display window that the eye tells apart in a texture.
constexpr double seenShare = 0.02;

/// Sums of three neighbours along an axis of `dims` numbers, whose side shrinks by two.
void sumAlong(int axis, glm::ivec3& dims, const std::vector<float>& from, std::vector<float>& to) {
  const VoxelBox before = wholeOf(dims);
  const std::size_t step = axis == 0 ? 1 : before.offset(axis == 1 ? glm::ivec3(0, 1, 0) : glm::ivec3(0, 0, 1));
  dims[axis] -= 2;
  to.resize(wholeOf(dims).count());
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) {
      const float* row = from.data() + before.offset({0, y, z});
      float* sums = to.data() + wholeOf(dims).offset({0, y, z});
      for (std::size_t x = 0; x < static_cast<std::size_t>(dims.x); ++x)
        sums[x] = row[x] + row[x + step] + row[x + 2 * step];
    }
}

/// Replaces numbers on a grid by means of 3×3×3 of them; each side shrinks by two.
void takeMeans(glm::ivec3 dims, std::vector<float>& values, std::vector<float>& scratch) {
  sumAlong(0, dims, values, scratch);
  sumAlong(1, dims, scratch, values);
  sumAlong(2, dims, values, scratch);
  for (float& value : scratch) value *= 1.0f / 27.0f;
  values.swap(scratch);
}

/// The voxels of `box`, which may reach beyond the volume: its edge is repeated there.
template <class T>
void readTones(std::span<const T> scalars, const Volume& volume, const VoxelBox& box, const ToneScale& scale,
               std::vector<float>& tones) {
  tones.resize(box.count());
  const glm::ivec3 last = volume.grid.dims - 1;
  float* to = tones.data();
  for (int z = box.low.z; z < box.high.z; ++z)
    for (int y = box.low.y; y < box.high.y; ++y) {
      const T* row = scalars.data() + volume.grid.offset({0, std::clamp(y, 0, last.y), std::clamp(z, 0, last.z)});
      const auto toneAt = [&](int x) { return static_cast<float>(scale(finiteValue(row[x], volume))); };
      const int first = std::clamp(0, box.low.x, box.high.x), end = std::clamp(last.x + 1, first, box.high.x);
      for (int x = box.low.x; x < first; ++x) *to++ = toneAt(0);
      for (int x = first; x < end; ++x) *to++ = toneAt(x);
      for (int x = end; x < box.high.x; ++x) *to++ = toneAt(last.x);
    }
}

}  // namespace

ToneScale::ToneScale(const Volume& volume, const Noise& noise, double reference) : noise_(noise) {
  if (volume.isInHounsfieldUnits())
    seen_ = {softTissueWindow.level - 0.5 * softTissueWindow.width,
             softTissueWindow.level + 0.5 * softTissueWindow.width};
  reference_ = toned(std::isfinite(reference) ? reference : volume.range.low);
  seenTones_ = {static_cast<float>((*this)(seen_.low)), static_cast<float>((*this)(seen_.high))};
}

Noise noiseOf(const Volume& volume) {
  const glm::ivec3 dims = volume.grid.dims;
  const double width = volume.isInHounsfieldUnits() ? softTissueWindow.width : volume.defaultWindow().width;
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
  if (differences.empty()) return {0.0, least, least};
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  // The median of a normal deviate's magnitude is 0.6745 σ; the difference has variance 1.5 σ².
  const double deviation = *middle / 0.6745 / std::sqrt(1.5);
  return {deviation, std::max(least, deviation), least};
}

std::span<const float> ToneSmoother::operator()(const VoxelBox& box) {
  const VoxelBox read = box.grownBy(glm::ivec3(2)), inner = box.grownBy(glm::ivec3(1));
  volume_.voxels.visit([&](auto scalars) { readTones(scalars, volume_, read, scale_, values_); });
  slope_.resize(values_.size());
  std::transform(values_.begin(), values_.end(), slope_.begin(), [](float v) { return v * v; });
  intercept_.assign(values_.begin(), values_.end());
  takeMeans(read.dims(), slope_, sums_);
  takeMeans(read.dims(), intercept_, sums_);
  // q = a v + b with a = σ² / (σ² + ε) and b = (1 - a) v̄, both averaged over the windows that hold the voxel. A volume
  // without noise needs no smoothing; ε keeps the quotient finite there.
  const auto share = static_cast<float>(scale_.noise().share());
  const float epsilon = std::max(1e-3f, flatness * share * share);
  for (std::size_t i = 0; i < slope_.size(); ++i) {
    const float mean = intercept_[i], variance = std::max(0.0f, slope_[i] - mean * mean);
    slope_[i] = variance / (variance + epsilon);
    intercept_[i] = (1.0f - slope_[i]) * mean;
  }
  takeMeans(inner.dims(), slope_, sums_);
  takeMeans(inner.dims(), intercept_, sums_);
  smoothed_.resize(box.count());
  const glm::ivec3 dims = box.dims();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) {
      const std::size_t begin = wholeOf(dims).offset({0, y, z});
      const float* row = values_.data() + wholeOf(read.dims()).offset({2, y + 2, z + 2});
      for (std::size_t x = 0; x < static_cast<std::size_t>(dims.x); ++x)
        smoothed_[begin + x] = slope_[begin + x] * row[x] + intercept_[begin + x];
    }
  return smoothed_;
}

std::vector<float> smoothedTones(const Volume& volume, const VoxelBox& box, const ToneScale& scale) {
  ToneSmoother smooth(volume, scale);
  const std::span<const float> tones = smooth(box);
  return {tones.begin(), tones.end()};
}

}  // namespace fenestra::segmentation
