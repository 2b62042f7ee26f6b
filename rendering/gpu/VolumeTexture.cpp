#include "rendering/gpu/VolumeTexture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "rendering/gl/Context.h"
#include "rendering/gpu/RenderError.h"
#include "rendering/gpu/UploadSlabs.h"
#include "rendering/scene/Lighting.h"
#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// A stored scalar with NaN and Inf replaced, so that filtering never meets them.
template <class T>
struct Sanitizer {
  T low, high, standIn;
  explicit Sanitizer(const Volume& volume) {
    const double a = (volume.range.low - volume.intercept) / volume.slope;
    const double b = (volume.range.high - volume.intercept) / volume.slope;
    low = static_cast<T>(std::min(a, b));
    high = static_cast<T>(std::max(a, b));
    standIn = static_cast<T>(a);
  }
  T operator()(T scalar) const {
    if constexpr (std::is_floating_point_v<T>) return std::isnan(scalar) ? standIn : std::clamp(scalar, low, high);
    return scalar;
  }
};

/// Calls use(row) for the rows of one plane of voxels.
template <class T, class Use>
void forEachRow(const ShownVoxels& voxels, int z, const Use& use) {
  std::vector<T> buffer;
  for (int y = 0; y < voxels.volume().grid.dims.y; ++y) use(voxels.row(y, z, buffer));
}

}  // namespace

ValueRange VolumeCoding::codedFromReal(ValueRange real) const {
  const double a = codedFromReal(real.low), b = codedFromReal(real.high);
  return {std::min(a, b), std::max(a, b)};
}

VolumeCoding codingOf(const Volume& volume) {
  VolumeCoding coding;
  coding.slope = volume.slope;
  volume.voxels.visit([&](auto scalars) {
    using T = typename decltype(scalars)::value_type;
    double base = 0.0;
    const double a = (volume.range.low - volume.intercept) / volume.slope;
    const double b = (volume.range.high - volume.intercept) / volume.slope;
    if constexpr (std::is_integral_v<T>) {
      const double low = std::round(std::min(a, b)), span = std::round(std::max(a, b)) - low;
      // Unsigned data that fit as they are need no conversion.
      coding.asStored = std::is_unsigned_v<T> && (sizeof(T) == 1 || (sizeof(T) == 2 && span > 255.0));
      base = coding.asStored ? 0.0 : low;
      coding.integers = span <= 65535.0;
      const bool oneByte = coding.asStored ? sizeof(T) == 1 : span <= 255.0;
      coding.format = oneByte ? gl::Format::R8 : coding.integers ? gl::Format::R16 : gl::Format::R32F;
    } else {
      // Values far from zero leave float32 few digits for their differences. What is within a factor of two of all
      // of them is taken away without rounding (Sterbenz's lemma).
      const double low = std::min(a, b), high = std::max(a, b);
      if (low > 0.0 && high <= 2.0 * low) base = static_cast<double>(static_cast<T>(low));
      if (high < 0.0 && low >= 2.0 * high) base = static_cast<double>(static_cast<T>(high));
    }
    coding.base = base;
    coding.offset = volume.slope * base + volume.intercept;
  });
  coding.texelScale = coding.format == gl::Format::R8 ? 255.0f : coding.format == gl::Format::R16 ? 65535.0f : 1.0f;
  return coding;
}

VolumeTexture makeVolumeTexture(const ShownVolume& shown) {
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
  const glm::ivec3 dims = volume.grid.dims;
  const int limit = gl::maxTextureSize3D();
  if (std::max({dims.x, dims.y, dims.z}) > limit)
    throw RenderError("the volume has " + std::to_string(dims.x) + "×" + std::to_string(dims.y) + "×" +
                      std::to_string(dims.z) + " voxels, 3-D textures here end at " + std::to_string(limit) +
                      " a side; resample it");
  VolumeTexture result{codingOf(volume), {}};
  result.texture = gl::Texture::make3D(result.format, dims);
  volume.voxels.visit([&](auto scalars) {
    using T = typename decltype(scalars)::value_type;
    const auto fill = [&]<class Texel>(Texel, const auto& coded) {
      uploadBySlabs<Texel>(result.texture, planeSize(dims), [&](int z, Texel* plane) {
        forEachRow<T>(voxels, z, [&](const T* from) {
          for (int x = 0; x < dims.x; ++x) *plane++ = static_cast<Texel>(coded(from[x]));
        });
      });
    };
    if constexpr (std::is_integral_v<T>) {
      const auto coded = [shift = static_cast<std::int64_t>(result.base)](T scalar) {
        return static_cast<std::int64_t>(scalar) - shift;
      };
      if (result.asStored && voxels.hidesNothing())
        result.texture.upload(scalars);
      else if (result.format == gl::Format::R8)
        fill(std::uint8_t{}, coded);
      else if (result.format == gl::Format::R16)
        fill(std::uint16_t{}, coded);
      else
        fill(float{}, coded);
    } else {
      fill(float{}, [finite = Sanitizer<T>(volume), base = static_cast<T>(result.base)](T scalar) {
        return finite(scalar) - base;
      });
    }
  });
  return result;
}

namespace {

/// World gradients of a row of voxels, in units of the gate, and the squares of their lengths.
struct RowGradients {
  explicit RowGradients(int width) : x(size(width)), y(size(width)), z(size(width)), length2(size(width)) {}
  static std::size_t size(int width) { return static_cast<std::size_t>(width); }

  std::vector<float> x, y, z, length2;
};

/// A voxel's row and those before and behind it along y and z.
template <class T>
struct RowsAround {
  const T *row, *front, *back, *below, *above;
};

/// Central differences at the voxels [begin, end) of a row, one-sided at its ends. `scales`: of differences along y, z.
template <class T>
void differentiate(const RowsAround<T>& rows, const Sanitizer<T>& sanitize, int width, int begin, int end,
                   glm::vec2 scales, const glm::mat3& worldFromIndexGradient, RowGradients& to) {
  const glm::mat3 m = worldFromIndexGradient;
  const auto at = [&](int x, int before, int after, float scale) {
    const auto difference = [&](T high, T low, float by) {
      return (static_cast<float>(sanitize(high)) - static_cast<float>(sanitize(low))) * by;
    };
    const float dx = difference(rows.row[after], rows.row[before], scale);
    const float dy = difference(rows.back[x], rows.front[x], scales.x);
    const float dz = difference(rows.above[x], rows.below[x], scales.y);
    const float gx = m[0][0] * dx + m[1][0] * dy + m[2][0] * dz;
    const float gy = m[0][1] * dx + m[1][1] * dy + m[2][1] * dz;
    const float gz = m[0][2] * dx + m[1][2] * dy + m[2][2] * dz;
    const auto i = static_cast<std::size_t>(x);
    to.x[i] = gx;
    to.y[i] = gy;
    to.z[i] = gz;
    to.length2[i] = gx * gx + gy * gy + gz * gz;
  };
  if (begin == 0) at(0, 0, std::min(1, width - 1), width > 1 ? 1.0f : 0.0f);
  for (int x = std::max(begin, 1); x < std::min(end, width - 1); ++x) at(x, x - 1, x + 1, 0.5f);
  if (end == width && width > 1) at(width - 1, width - 2, width - 1, 1.0f);
}

/// Writes the normals of [begin, end) whose gradients pass the gate, as RGB10A2.
void writeNormals(const RowGradients& gradients, int begin, int end, std::uint32_t* out) {
  constexpr auto gateLow = static_cast<float>(lighting::gradientGateLow);
  constexpr auto gateHigh = static_cast<float>(lighting::gradientGateHigh);
  for (int x = begin; x < end; ++x) {
    const auto i = static_cast<std::size_t>(x);
    const float length2 = gradients.length2[i];
    if (!(length2 > gateLow * gateLow)) continue;
    const float length = std::sqrt(length2);
    const glm::vec3 g(gradients.x[i], gradients.y[i], gradients.z[i]);
    const glm::vec3 n = g * (glm::smoothstep(gateLow, gateHigh, length) / length * 511.0f) + 511.5f;  // truncated
    out[x] =
        static_cast<std::uint32_t>(n.x) | static_cast<std::uint32_t>(n.y) << 10 | static_cast<std::uint32_t>(n.z) << 20;
  }
}

}  // namespace

GradientTexture makeGradientTexture(const ShownVolume& shown, const std::optional<IndexBox>& box) {
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
  const glm::ivec3 dims = volume.grid.dims;
  const glm::ivec3 low = box ? box->low : glm::ivec3(0), high = box ? box->high : glm::ivec3(-1);
  GradientTexture result;
  result.origin = glm::max(low - 1, glm::ivec3(0));
  const glm::ivec3 size = glm::min(high + 1, dims - 1) - result.origin + 1;
  result.texture = gl::Texture::make3D(gl::Format::RGB10A2, size);
  const glm::dvec3 spacing = volume.grid.spacing;
  const double unit =
      std::max(volume.range.high - volume.range.low, 1e-30) / std::min({spacing.x, spacing.y, spacing.z});
  // World gradient = (index from world)ᵀ · index gradient.
  const glm::mat3 worldFromIndexGradient(glm::transpose(glm::dmat3(volume.grid.indexFromWorld())) * volume.slope /
                                         unit);
  constexpr std::uint32_t flat = 511u | 511u << 10 | 511u << 20;
  volume.voxels.visit([&](auto scalars) {
    using T = typename decltype(scalars)::value_type;
    const Sanitizer<T> sanitize(volume);
    uploadBySlabs<std::uint32_t>(result.texture, planeSize(size), [&](int depth, std::uint32_t* plane) {
      std::fill_n(plane, planeSize(size), flat);
      const int z = result.origin.z + depth;
      if (z < low.z || z > high.z) return;
      const int zLow = std::max(z - 1, 0), zHigh = std::min(z + 1, dims.z - 1);
      const float zScale = zHigh > zLow ? 1.0f / static_cast<float>(zHigh - zLow) : 0.0f;
      std::array<std::vector<T>, 5> buffers;
      RowGradients gradients(dims.x);
      for (int y = low.y; y <= high.y; ++y) {
        const int yLow = std::max(y - 1, 0), yHigh = std::min(y + 1, dims.y - 1);
        const float yScale = yHigh > yLow ? 1.0f / static_cast<float>(yHigh - yLow) : 0.0f;
        const RowsAround<T> rows{.row = voxels.row(y, z, buffers[0]),
                                 .front = voxels.row(yLow, z, buffers[3]),
                                 .back = voxels.row(yHigh, z, buffers[4]),
                                 .below = voxels.row(y, zLow, buffers[2]),
                                 .above = voxels.row(y, zHigh, buffers[1])};
        differentiate(rows, sanitize, dims.x, low.x, high.x + 1, {yScale, zScale}, worldFromIndexGradient, gradients);
        writeNormals(
            gradients, low.x, high.x + 1,
            plane + static_cast<std::size_t>(y - result.origin.y) * static_cast<std::size_t>(size.x) - result.origin.x);
      }
    });
  });
  return result;
}

namespace {

/// A tap of the filter that reduces a volume along an axis: texel i reads voxel factor · i + offset.
struct Tap {
  int offset;
  float weight;
};

std::vector<Tap> tapsOf(int factor) {
  if (factor == 2) return {{-1, 0.125f}, {0, 0.375f}, {1, 0.375f}, {2, 0.125f}};
  return {{0, 1.0f}};
}

/// Voxels a texel along each axis: two where they are near each other and many.
glm::ivec3 reductionOf(const Grid& grid) {
  const double finest = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
  glm::ivec3 factor;
  for (int axis = 0; axis < 3; ++axis) factor[axis] = grid.spacing[axis] < 2.0 * finest && grid.dims[axis] >= 8 ? 2 : 1;
  return factor;
}

}  // namespace

namespace {

/// Taps along y and z around a texel, and the voxels that they read.
struct Taps {
  std::vector<Tap> y, z;
  glm::ivec3 factor, last;

  int yOf(int texel, const Tap& tap) const { return std::clamp(texel * factor.y + tap.offset, 0, last.y); }
  int zOf(int texel, const Tap& tap) const { return std::clamp(texel * factor.z + tap.offset, 0, last.z); }
};

/// Rows of coded voxels joined by taps along y and z, where the coded values are small integers. To be asked for texels
/// with ascending y: rows joined along z serve for the next ones, too.
template <class T>
class JoinedIntegers {
 public:
  JoinedIntegers(const ShownVoxels& voxels, const Taps& taps, double base)
      : voxels_(voxels), taps_(taps), base_(static_cast<int>(base)) {
    for (Row& row : rows_) row.eighths.resize(static_cast<std::size_t>(voxels.volume().grid.dims.x));
  }

  /// Whether sums of eight coded values fit.
  static bool fits(double base, double greatestCoded) {
    return base == std::round(base) && 8.0 * greatestCoded <= 65535.0;
  }

  void fill(int y, int z, std::span<float> column) {
    std::fill(column.begin(), column.end(), 0.0f);
    for (const Tap& tap : taps_.y) {
      const std::uint16_t* eighths = joined(taps_.yOf(y, tap), z);
      const float weight = 0.125f * tap.weight;
      for (std::size_t x = 0; x < column.size(); ++x) column[x] += weight * static_cast<float>(eighths[x]);
    }
  }

 private:
  struct Row {
    glm::ivec2 at{-1};  ///< voxel along y, texel along z
    std::vector<std::uint16_t> eighths;
  };

  const std::uint16_t* joined(int y, int z) {
    Row& row = rows_[static_cast<std::size_t>(y) % rows_.size()];
    std::uint16_t* to = row.eighths.data();
    if (std::exchange(row.at, glm::ivec2(y, z)) == glm::ivec2(y, z)) return to;
    std::fill(row.eighths.begin(), row.eighths.end(), std::uint16_t{0});
    for (const Tap& tap : taps_.z) {
      const T* from = voxels_.row(y, taps_.zOf(z, tap), buffer_);
      const auto times = static_cast<std::uint16_t>(8.0f * tap.weight);
      const auto shift = static_cast<std::uint16_t>(base_ * times);
      for (std::size_t x = 0; x < row.eighths.size(); ++x)
        to[x] = static_cast<std::uint16_t>(to[x] + times * static_cast<std::uint16_t>(from[x]) - shift);
    }
    return to;
  }

  const ShownVoxels& voxels_;
  const Taps& taps_;
  int base_;
  std::array<Row, 4> rows_;  ///< as many as taps
  std::vector<T> buffer_;
};

/// Rows of any coded voxels joined by taps along y and z.
template <class T>
class JoinedNumbers {
 public:
  JoinedNumbers(const ShownVoxels& voxels, const Taps& taps, double base)
      : voxels_(voxels), taps_(taps), base_(base), sanitize_(voxels.volume()) {}

  void fill(int y, int z, std::span<float> column) {
    std::fill(column.begin(), column.end(), 0.0f);
    for (const Tap& a : taps_.z)
      for (const Tap& b : taps_.y) {
        const T* row = voxels_.row(taps_.yOf(y, b), taps_.zOf(z, a), buffer_);
        const float weight = a.weight * b.weight;
        for (std::size_t x = 0; x < column.size(); ++x)
          column[x] += weight * static_cast<float>(static_cast<double>(sanitize_(row[x])) - base_);
      }
  }

 private:
  const ShownVoxels& voxels_;
  const Taps& taps_;
  double base_;
  Sanitizer<T> sanitize_;
  std::vector<T> buffer_;
};

/// Every texel of a row by taps along x. `column` may be read beyond its ends as far as the taps reach.
template <class Use>
void joinAlongX(const float* column, int factor, std::size_t texels, const Use& use) {
  if (factor == 1) {
    for (std::size_t x = 0; x < texels; ++x) use(x, column[x]);
    return;
  }
  for (std::size_t x = 0; x < texels; ++x) {
    const float* from = column + 2 * x;
    use(x, 0.125f * from[-1] + 0.375f * from[0] + 0.375f * from[1] + 0.125f * from[2]);
  }
}

}  // namespace

DerivativeVolume makeDerivativeVolume(const ShownVolume& shown) {
  const Volume& volume = *shown.volume;
  const VolumeCoding coding = codingOf(volume);
  const ShownVoxels voxels(shown);
  const Grid& grid = volume.grid;
  DerivativeVolume result;
  result.factor = reductionOf(grid);
  const glm::ivec3 dims = (grid.dims + result.factor - 1) / result.factor;
  const glm::dvec3 spacing = grid.spacing * glm::dvec3(result.factor);
  result.spacing = std::min({spacing.x, spacing.y, spacing.z});
  const bool wide = !coding.integers;
  result.texture = gl::Texture::make3D(wide ? gl::Format::R32F : gl::Format::R16, dims);
  // Stretched over all 16 bits, so that smoothing keeps what lies between the data's own steps.
  const ValueRange coded = coding.codedFromReal(volume.range);
  const float stretch = static_cast<float>(65535.0 / std::max(coded.high, 1.0));
  result.texelScale = (wide ? 1.0f : 65535.0f / stretch) * coding.slope;
  const Taps taps{tapsOf(result.factor.y), tapsOf(result.factor.z), result.factor, grid.dims - 1};
  constexpr std::size_t reach = 2;  // of the taps along x: the column is repeated beyond its ends
  const auto width = static_cast<std::size_t>(grid.dims.x), texels = static_cast<std::size_t>(dims.x);
  const auto smooth = [&](const auto& newRows) {
    const auto plane = [&](int z, auto* out) {
      std::vector<float> padded(width + 2 * reach);
      const std::span<float> column = std::span(padded).subspan(reach, width);
      auto rows = newRows();
      for (int y = 0; y < dims.y; ++y, out += texels) {
        rows.fill(y, z, column);
        std::fill_n(padded.begin(), reach, column.front());
        std::fill_n(padded.end() - reach, reach, column.back());
        using Texel = std::remove_reference_t<decltype(out[0])>;
        joinAlongX(column.data(), result.factor.x, texels, [&](std::size_t x, float sum) {
          if constexpr (std::is_same_v<Texel, float>)
            out[x] = sum;
          else
            out[x] = static_cast<Texel>(std::clamp(sum * stretch + 0.5f, 0.0f, 65535.0f));
        });
      }
    };
    if (wide)
      uploadBySlabs<float>(result.texture, planeSize(dims), plane);
    else
      uploadBySlabs<std::uint16_t>(result.texture, planeSize(dims), plane);
  };
  volume.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::value_type>;
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2)
      if (JoinedIntegers<T>::fits(coding.base, coded.high))
        return smooth([&] { return JoinedIntegers<T>(voxels, taps, coding.base); });
    smooth([&] { return JoinedNumbers<T>(voxels, taps, coding.base); });
  });
  return result;
}

}  // namespace fenestra
