#include "rendering/gpu/RefinedSampler.h"

#include <algorithm>

// Debian's programs must run on every amd64 processor. Nearly all have AVX2, which halves the time, and fuses no
// multiplication with an addition: both versions round alike. ThreadSanitizer does not run yet when one is chosen.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define FENESTRA_WIDE_ROWS __attribute__((target_clones("avx2", "default")))
#else
#define FENESTRA_WIDE_ROWS
#endif

namespace fenestra {
namespace {

using FourRows = std::array<const double*, 4>;

/// result[i] = Σ weights[k] · rows[k][i].
FENESTRA_WIDE_ROWS void addRows(const FourRows& rows, const std::array<double, 4>& weights, std::size_t count,
                                double* result) {
  const auto [a, b, c, d] = rows;
  const auto [wa, wb, wc, wd] = weights;
  for (std::size_t i = 0; i < count; ++i) result[i] = ((wa * a[i] + wb * b[i]) + wc * c[i]) + wd * d[i];
}

/// samples[i · step] = Σ weights[k][i] · c[i + k].
FENESTRA_WIDE_ROWS void sampleRow(const double* c, const FourRows& weights, std::size_t step, std::size_t count,
                                  double* samples) {
  const auto [wa, wb, wc, wd] = weights;
  for (std::size_t i = 0; i < count; ++i)
    samples[i * step] = (wa[i] * c[i] + wb[i] * c[i + 1]) + (wc[i] * c[i + 2] + wd[i] * c[i + 3]);
}

FENESTRA_WIDE_ROWS void setBits(const double* components, std::size_t count, int shift, std::uint32_t* texels) {
  const std::uint32_t others = ~(1023u << shift);
  for (std::size_t i = 0; i < count; ++i) {
    const double coded = std::min(std::max(components[i], -1.0), 1.0) * 511.0 + 511.5;
    texels[i] = (texels[i] & others) | static_cast<std::uint32_t>(static_cast<std::int32_t>(coded)) << shift;
  }
}

FENESTRA_WIDE_ROWS void round(const double* values, std::size_t count, double least, double scale,
                              std::uint16_t* stored) {
  for (std::size_t i = 0; i < count; ++i) {
    const double coded = std::min(std::max((values[i] - least) * scale + 0.5, 0.0), 65535.0);
    stored[i] = static_cast<std::uint16_t>(static_cast<std::int32_t>(coded));
  }
}

}  // namespace

RefinedSampler::Taps::Taps(int count, int factor) : count_(count), factor_(factor) {
  const double share = 1.0 / (12.0 * factor * factor);
  const auto size = static_cast<std::size_t>(count) * static_cast<std::size_t>(factor);
  voxels_.resize(size);
  for (std::vector<double>& weights : weights_) weights.resize(size);
  for (int k = 0; k < count * factor; ++k) {
    const double index = (k - 0.5 * (factor - 1)) / factor;
    const SplinePlace at(index, count);
    const SplineWeights weights(at.t);
    // Beyond the outermost voxels f does not bend.
    const bool bends = index > 0.0 && index < count - 1;
    const glm::dvec4 taken = bends ? weights.value - share * weights.bend : weights.value;
    voxels_[place(k)] = at.voxel;
    for (int of = 0; of < 4; ++of) weights_[static_cast<std::size_t>(of)][place(k)] = taken[of];
  }
}

RefinedSampler::RefinedSampler(const SplineVolume& spline, int factor)
    : spline_(spline),
      factor_(factor),
      x_(spline.dims().x, factor),
      y_(spline.dims().y, factor),
      z_(spline.dims().z, factor) {}

std::vector<double> RefinedSampler::plane(int z) const {
  const auto width = static_cast<std::size_t>(spline_.size().x), rows = static_cast<std::size_t>(spline_.size().y);
  const int first = z_.voxel(z) - 1;
  const auto rowOf = [&](std::size_t j, int k) { return spline_.row(static_cast<int>(j) - 1, first + k); };
  std::vector<double> result(width * rows);
  for (std::size_t j = 0; j < rows; ++j)
    addRows({rowOf(j, 0), rowOf(j, 1), rowOf(j, 2), rowOf(j, 3)},
            {z_.weight(z, 0), z_.weight(z, 1), z_.weight(z, 2), z_.weight(z, 3)}, width, result.data() + j * width);
  return result;
}

void RefinedSampler::row(const std::vector<double>& plane, int y, std::vector<double>& coefficients, int low,
                         std::span<double> samples) const {
  const auto width = static_cast<std::size_t>(spline_.size().x);
  const double* first = plane.data() + static_cast<std::size_t>(y_.voxel(y)) * width;
  coefficients.resize(width);
  addRows({first, first + width, first + 2 * width, first + 3 * width},
          {y_.weight(y, 0), y_.weight(y, 1), y_.weight(y, 2), y_.weight(y, 3)}, width, coefficients.data());
  const auto sample = [&](int x, int step, int count) {
    sampleRow(coefficients.data() + x_.voxel(x),
              {x_.weightsFrom(x, 0), x_.weightsFrom(x, 1), x_.weightsFrom(x, 2), x_.weightsFrom(x, 3)},
              static_cast<std::size_t>(step), static_cast<std::size_t>(count),
              &samples[static_cast<std::size_t>(x - low)]);
  };
  const int high = low + static_cast<int>(samples.size());
  const int begin = std::clamp(x_.firstEven(), low, high), end = std::clamp(x_.endEven(), begin, high);
  for (int x = low; x < begin; ++x) sample(x, 1, 1);
  for (int x = begin; x < std::min(begin + factor_, end); ++x) sample(x, factor_, (end - x + factor_ - 1) / factor_);
  for (int x = end; x < high; ++x) sample(x, 1, 1);
}

void setTenBits(std::span<const double> components, int shift, std::uint32_t* texels) {
  setBits(components.data(), components.size(), shift, texels);
}

void toSixteenBits(std::span<const double> values, double least, double scale, std::uint16_t* stored) {
  round(values.data(), values.size(), least, scale, stored);
}

}  // namespace fenestra
