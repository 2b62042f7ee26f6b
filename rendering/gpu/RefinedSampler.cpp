#include "rendering/gpu/RefinedSampler.h"

#include <algorithm>

#include "rendering/gpu/WideRows.h"

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

inline double sampleAt(const double* c, const FourRows& weights, std::size_t i) {
  const auto& [wa, wb, wc, wd] = weights;
  return (wa[i] * c[i] + wb[i] * c[i + 1]) + (wc[i] * c[i + 2] + wd[i] * c[i + 3]);
}

inline std::uint32_t truncated(double value) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(value)); }

/// Clamped last: compilers fold what follows a bound, and do not vectorize the branch that this takes.
inline std::uint32_t tenBits(double component) {
  return truncated(std::min(std::max(component * 511.0 + 511.5, 0.5), 1022.5));
}

/// samples[i · step] = Σ weights[k][i] · c[i + k].
FENESTRA_WIDE_ROWS void sampleRow(const double* c, const FourRows& weights, std::size_t step, std::size_t count,
                                  double* samples) {
  for (std::size_t i = 0; i < count; ++i) samples[i * step] = sampleAt(c, weights, i);
}

/// coded[i] = (such a sample - least) · scale, rounded, in 0 … 65535.
FENESTRA_WIDE_ROWS void codeRow(const double* c, const FourRows& weights, double least, double scale, std::size_t count,
                                std::uint32_t* coded) {
  for (std::size_t i = 0; i < count; ++i) {
    const double value = (sampleAt(c, weights, i) - least) * scale + 0.5;
    coded[i] = truncated(std::min(std::max(value, 0.0), 65535.0));
  }
}

/// coded[i] = three such samples, ten bits each.
FENESTRA_WIDE_ROWS void codeNormals(const std::array<const double*, 3>& c, const FourRows& weights, std::size_t count,
                                    std::uint32_t* coded) {
  const auto [x, y, z] = c;
  for (std::size_t i = 0; i < count; ++i)
    coded[i] = tenBits(sampleAt(x, weights, i)) | tenBits(sampleAt(y, weights, i)) << 10 |
               tenBits(sampleAt(z, weights, i)) << 20;
}

FENESTRA_WIDE_ROWS void setBits(const double* components, std::size_t count, int shift, std::uint32_t* texels) {
  const std::uint32_t others = ~(1023u << shift);
  for (std::size_t i = 0; i < count; ++i) texels[i] = (texels[i] & others) | tenBits(components[i]) << shift;
}

/// Adds to the components of gradients what the coefficients c of one row around them give: x from the slope along x,
/// which is half of what is behind less half of what is before, y and z from the value.
FENESTRA_WIDE_ROWS void addGradients(const double* c, const std::array<double, 4>& value,
                                     const std::array<double, 4>& slope, glm::dvec2 y, glm::dvec2 z, std::size_t count,
                                     const std::array<double*, 3>& sums) {
  const auto [va, vb, vc, vd] = value;
  const auto [sa, sb, sc, sd] = slope;
  const double yValue = y.x, ySlope = y.y, zValue = z.x, zSlope = z.y;
  const auto [xs, ys, zs] = sums;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = c[i], b = c[i + 1], d = c[i + 2], e = c[i + 3];
    const double own = (va * a + vb * b) + (vc * d + vd * e), rise = (sa * a + sb * b) + (sc * d + sd * e);
    xs[i] += rise * yValue * zValue;
    ys[i] += own * ySlope * zValue;
    zs[i] += own * yValue * zSlope;
  }
}

std::array<double, 4> arrayOf(const glm::dvec4& weights) { return {weights.x, weights.y, weights.z, weights.w}; }

}  // namespace

void voxelGradients(const SplineVolume& spline, int y, int z, std::span<glm::dvec3> gradients) {
  const glm::ivec3 dims = spline.dims();
  const SplinePlace yPlace(y, dims.y), zPlace(z, dims.z);
  const SplineWeights onVoxel(0.0), yWeights(yPlace.t), zWeights(zPlace.t);
  // The last voxel ends the cell before it.
  const std::size_t even = dims.x > 1 ? gradients.size() - 1 : gradients.size();
  std::vector<double> sums(3 * even, 0.0);
  const std::array<double*, 3> axes{sums.data(), sums.data() + even, sums.data() + 2 * even};
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      const glm::dvec2 yTap(yWeights.value[j], yWeights.slope[j]), zTap(zWeights.value[k], zWeights.slope[k]);
      if (yTap == glm::dvec2(0.0) || zTap == glm::dvec2(0.0)) continue;  // of four around a voxel, one counts nothing
      addGradients(spline.row(yPlace.voxel + j - 1, zPlace.voxel + k - 1), arrayOf(onVoxel.value),
                   arrayOf(onVoxel.slope), yTap, zTap, even, axes);
    }
  for (std::size_t x = 0; x < even; ++x) gradients[x] = {axes[0][x], axes[1][x], axes[2][x]};
  if (even < gradients.size()) gradients.back() = spline.gradient({dims.x - 1, y, z});
}

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

void RefinedSampler::join(const std::vector<double>& plane, int y, std::vector<double>& coefficients) const {
  const auto width = static_cast<std::size_t>(spline_.size().x);
  const double* first = plane.data() + static_cast<std::size_t>(y_.voxel(y)) * width;
  coefficients.resize(width);
  addRows({first, first + width, first + 2 * width, first + 3 * width},
          {y_.weight(y, 0), y_.weight(y, 1), y_.weight(y, 2), y_.weight(y, 3)}, width, coefficients.data());
}

template <class Use>
void RefinedSampler::forEachRun(int low, int high, const Use& use) const {
  const int begin = std::clamp(x_.firstEven(), low, high), end = std::clamp(x_.endEven(), begin, high);
  for (int x = low; x < begin; ++x) use(x, std::size_t{1}, std::size_t{1});
  for (int x = begin; x < std::min(begin + factor_, end); ++x)
    use(x, static_cast<std::size_t>(factor_), static_cast<std::size_t>((end - x + factor_ - 1) / factor_));
  for (int x = end; x < high; ++x) use(x, std::size_t{1}, std::size_t{1});
}

void RefinedSampler::row(const std::vector<double>& plane, int y, Room& room, std::span<double> samples) const {
  std::vector<double>& coefficients = room.coefficients.front();
  join(plane, y, coefficients);
  forEachRun(0, static_cast<int>(samples.size()), [&](int x, std::size_t step, std::size_t count) {
    sampleRow(coefficients.data() + x_.voxel(x), x_.weightsFrom(x), step, count,
              samples.data() + static_cast<std::size_t>(x));
  });
}

void RefinedSampler::row(const std::vector<double>& plane, int y, Room& room, double least, double scale,
                         std::span<std::uint16_t> stored) const {
  std::vector<double>& coefficients = room.coefficients.front();
  join(plane, y, coefficients);
  room.coded.resize(stored.size());
  forEachRun(0, static_cast<int>(stored.size()), [&](int x, std::size_t step, std::size_t count) {
    codeRow(coefficients.data() + x_.voxel(x), x_.weightsFrom(x), least, scale, count, room.coded.data());
    std::uint16_t* to = stored.data() + static_cast<std::size_t>(x);
    for (std::size_t i = 0; i < count; ++i) to[i * step] = static_cast<std::uint16_t>(room.coded[i]);
  });
}

void RefinedSampler::normals(const std::array<std::vector<double>, 3>& planes, int y, Room& room, int low,
                             std::span<std::uint32_t> texels) const {
  for (std::size_t axis = 0; axis < 3; ++axis) join(planes[axis], y, room.coefficients[axis]);
  room.coded.resize(texels.size());
  forEachRun(low, low + static_cast<int>(texels.size()), [&](int x, std::size_t step, std::size_t count) {
    const auto from = [&](std::size_t axis) { return room.coefficients[axis].data() + x_.voxel(x); };
    codeNormals({from(0), from(1), from(2)}, x_.weightsFrom(x), count, room.coded.data());
    std::uint32_t* to = texels.data() + static_cast<std::size_t>(x - low);
    for (std::size_t i = 0; i < count; ++i) to[i * step] = room.coded[i];
  });
}

void setTenBits(std::span<const double> components, int shift, std::uint32_t* texels) {
  setBits(components.data(), components.size(), shift, texels);
}

}  // namespace fenestra
