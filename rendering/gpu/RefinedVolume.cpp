#include "rendering/gpu/RefinedVolume.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "rendering/gpu/UploadSlabs.h"
#include "rendering/scene/Lighting.h"

namespace fenestra {
namespace {

/// A refined voxel's weights of the four coefficients around it along an axis.
struct Tap {
  int voxel = 0;  ///< the second of the four
  glm::dvec4 weights;
};

/// Those of all refined voxels along an axis of `count` voxels.
std::vector<Tap> tapsAlong(int count, int factor) {
  const double share = 1.0 / (12.0 * factor * factor);
  std::vector<Tap> taps;
  for (int k = 0; k < count * factor; ++k) {
    const double index = (k - 0.5 * (factor - 1)) / factor;
    const SplinePlace place(index, count);
    const SplineWeights weights(place.t);
    // Beyond the outermost voxels f does not bend.
    const bool bends = index > 0.0 && index < count - 1;
    taps.push_back({place.voxel, bends ? weights.value - share * weights.bend : weights.value});
  }
  return taps;
}

/// Evaluates refined planes of a spline, axis by axis.
class Sampler {
 public:
  Sampler(const SplineVolume& spline, int factor)
      : spline_(spline),
        x_(tapsAlong(spline.dims().x, factor)),
        y_(tapsAlong(spline.dims().y, factor)),
        z_(tapsAlong(spline.dims().z, factor)) {}

  /// Coefficients of x and y in the plane of a refined z.
  std::vector<double> plane(int z) const {
    const Tap& tap = z_[static_cast<std::size_t>(z)];
    const auto width = static_cast<std::size_t>(spline_.size().x), rows = static_cast<std::size_t>(spline_.size().y);
    std::vector<double> result(width * rows);
    for (std::size_t j = 0; j < rows; ++j) {
      double* to = result.data() + j * width;
      for (int k = 0; k < 4; ++k) {
        const double* from = spline_.row(static_cast<int>(j) - 1, tap.voxel + k - 1);
        for (std::size_t i = 0; i < width; ++i) to[i] += tap.weights[k] * from[i];
      }
    }
    return result;
  }

  /// Coefficients of x in the row of a refined y of such a plane.
  void row(const std::vector<double>& plane, int y, std::vector<double>& result) const {
    const Tap& tap = y_[static_cast<std::size_t>(y)];
    const auto width = static_cast<std::size_t>(spline_.size().x);
    result.assign(width, 0.0);
    for (int j = 0; j < 4; ++j) {
      const double* from = plane.data() + static_cast<std::size_t>(tap.voxel + j) * width;
      for (std::size_t i = 0; i < width; ++i) result[i] += tap.weights[j] * from[i];
    }
  }

  double at(const std::vector<double>& row, int x) const {
    const Tap& tap = x_[static_cast<std::size_t>(x)];
    const double* c = row.data() + tap.voxel;
    return glm::dot(glm::dvec4(c[0], c[1], c[2], c[3]), tap.weights);
  }

 private:
  const SplineVolume& spline_;
  std::vector<Tap> x_, y_, z_;
};

bool fitsSixteenBits(const Volume& volume) {
  const ScalarType type = volume.voxels.type();
  return type != ScalarType::Float32 && type != ScalarType::Float64 &&
         (volume.range.high - volume.range.low) / std::abs(volume.slope) <= 65535.0;
}

/// A component of a normal in RGB10A2, zero at 511/1023.
std::uint32_t tenBits(double component) {
  return static_cast<std::uint32_t>(std::clamp(component, -1.0, 1.0) * 511.0 + 511.5);
}

/// Greatest second difference along an axis at the samples in a box, as stored.
template <class T>
double greatestBend(std::span<T> scalars, const Grid& grid, IndexBox box, int axis) {
  using Stored = std::remove_const_t<T>;
  using Wide = std::conditional_t<std::is_integral_v<Stored> && sizeof(Stored) <= 2, std::int32_t, double>;
  box.low[axis] = std::max(box.low[axis], 1);
  box.high[axis] = std::min(box.high[axis], grid.dims[axis] - 2);
  glm::ivec3 next(0);
  next[axis] = 1;
  const std::size_t stride = grid.offset(next),
                    width = static_cast<std::size_t>(std::max(box.high.x - box.low.x + 1, 0));
  Wide greatest = 0;
  for (int z = box.low.z; z <= box.high.z; ++z)
    for (int y = box.low.y; y <= box.high.y; ++y) {
      const T* row = scalars.data() + grid.offset({box.low.x, y, z});
      for (const T* at = row; at != row + width; ++at) {
        const Wide bend = static_cast<Wide>(at[-static_cast<std::ptrdiff_t>(stride)]) - 2 * static_cast<Wide>(*at) +
                          static_cast<Wide>(at[stride]);
        greatest = std::max(greatest, bend < 0 ? -bend : bend);
      }
    }
  return static_cast<double>(greatest);
}

template <class T, class Coded>
void sample(Volume& volume, const Sampler& sampler, const Coded& coded) {
  const glm::ivec3 dims = volume.grid.dims;
  parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> row;
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z) {
      const std::vector<double> plane = sampler.plane(z);
      T* out = volume.voxels.as<T>().data() + volume.grid.offset({0, 0, z});
      for (int y = 0; y < dims.y; ++y) {
        sampler.row(plane, y, row);
        for (int x = 0; x < dims.x; ++x) *out++ = coded(sampler.at(row, x));
      }
    }
  });
}

}  // namespace

Grid refined(const Grid& grid, int factor) {
  Grid result = grid;
  result.dims *= factor;
  result.spacing /= factor;
  const glm::dvec3 first(-0.5 * (factor - 1) / factor);
  result.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(first, 1.0));
  return result;
}

std::shared_ptr<const Volume> refinedVolume(const Volume& volume, const SplineVolume& spline, int factor) {
  auto result = std::make_shared<Volume>();
  result->grid = refined(volume.grid, factor);
  const bool narrow = fitsSixteenBits(volume);
  result->voxels = Voxels(narrow ? ScalarType::UInt16 : ScalarType::Float32, result->grid.voxelCount());
  result->range = spline.range();
  const Sampler sampler(spline, factor);
  const auto [low, high] = spline.range();
  if (narrow) {
    const double last = 65535.0;
    result->slope = high > low ? (high - low) / last : 1.0;
    result->intercept = low;
    const double perReal = 1.0 / result->slope;
    sample<std::uint16_t>(*result, sampler, [perReal, last, least = low](double value) {
      return static_cast<std::uint16_t>(std::clamp((value - least) * perReal + 0.5, 0.0, last));
    });
  } else {
    sample<float>(*result, sampler, [least = low, greatest = high](double value) {
      return static_cast<float>(std::clamp(value, least, greatest));
    });
  }
  return result;
}

std::size_t refinedBytes(const Volume& volume, int factor, bool lit) {
  const double texel = fitsSixteenBits(volume) ? 2.0 : 4.0, gradient = lit ? 4.0 : 0.0;
  const double coefficient = sizeof(double) + sizeof(glm::vec4) + (lit ? 3.0 * sizeof(double) + 4.0 : 0.0);
  constexpr double brick = (sizeof(ValueRange) + 7.0) / static_cast<double>(cellsPerBrick);
  const double perVoxel = std::pow(factor, 3.0) * (2.0 * texel + gradient + brick) + coefficient;
  return static_cast<std::size_t>(perVoxel * static_cast<double>(volume.grid.voxelCount()));
}

SplineVectors gatedNormals(const Volume& volume, const SplineVolume& spline) {
  const glm::dvec3 spacing = volume.grid.spacing;
  const double unit =
      std::max(volume.range.high - volume.range.low, 1e-30) / std::min({spacing.x, spacing.y, spacing.z});
  const glm::dmat3 worldFromIndexGradient = glm::transpose(glm::dmat3(volume.grid.indexFromWorld())) / unit;
  return SplineVectors(volume.grid.dims, [&](glm::ivec3 voxel) {
    const glm::dvec3 g = worldFromIndexGradient * spline.gradient(glm::dvec3(voxel));
    const double length = glm::length(g);
    if (!(length > lighting::gradientGateLow)) return glm::dvec3(0.0);
    return g * (glm::smoothstep(lighting::gradientGateLow, lighting::gradientGateHigh, length) / length);
  });
}

gl::Texture makeCoefficients(const SplineVectors& normals) {
  const glm::ivec3 size = normals.part(0).size();
  gl::Texture texture = gl::Texture::make3D(gl::Format::RGB10A2, size);
  uploadBySlabs<std::uint32_t>(texture, planeSize(size), [&](int z, std::uint32_t* plane) {
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const auto at = [&](int axis) { return tenBits(normals.part(axis).row(y - 1, z - 1)[x]); };
        *plane++ = at(0) | at(1) << 10 | at(2) << 20;
      }
  });
  return texture;
}

GradientTexture makeRefinedGradient(const SplineVectors& normals, int factor, const std::optional<IndexBox>& box) {
  const glm::ivec3 dims = normals.part(0).dims() * factor;
  const glm::ivec3 low = box ? box->low : glm::ivec3(0), high = box ? box->high : glm::ivec3(-1);
  GradientTexture result;
  result.origin = glm::max(low - 1, glm::ivec3(0));
  const glm::ivec3 size = glm::min(high + 1, dims - 1) - result.origin + 1;
  result.texture = gl::Texture::make3D(gl::Format::RGB10A2, size);
  const std::array<Sampler, 3> samplers{Sampler(normals.part(0), factor), Sampler(normals.part(1), factor),
                                        Sampler(normals.part(2), factor)};
  constexpr std::uint32_t flat = 511u | 511u << 10 | 511u << 20;
  uploadBySlabs<std::uint32_t>(result.texture, planeSize(size), [&](int depth, std::uint32_t* texels) {
    std::fill_n(texels, planeSize(size), flat);
    const int z = result.origin.z + depth;
    if (z < low.z || z > high.z) return;
    std::vector<double> row;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::vector<double> plane = samplers[axis].plane(z);
      for (int y = low.y; y <= high.y; ++y) {
        samplers[axis].row(plane, y, row);
        std::uint32_t* out =
            texels + static_cast<std::size_t>(y - result.origin.y) * static_cast<std::size_t>(size.x) - result.origin.x;
        for (int x = low.x; x <= high.x; ++x) {
          const std::uint32_t component = tenBits(samplers[axis].at(row, x));
          out[x] = (out[x] & ~(1023u << 10 * axis)) | component << 10 * axis;
        }
      }
    }
  });
  return result;
}

gl::Texture makeCoefficients(const SplineVolume& spline, const VolumeCoding& coding) {
  const glm::ivec3 size = spline.size() - glm::ivec3(3, 0, 0);
  gl::Texture texture = gl::Texture::make3D(gl::Format::RGBA32F, size);
  uploadBySlabs<glm::vec4>(texture, planeSize(size), [&](int z, glm::vec4* plane) {
    for (int y = 0; y < size.y; ++y) {
      const double* row = spline.row(y - 1, z - 1);
      const auto at = [&](int x) { return coding.codedFromReal(row[x]); };
      for (int x = 0; x < size.x; ++x) *plane++ = glm::vec4(at(x), at(x + 1), at(x + 2), at(x + 3));
    }
  });
  return texture;
}

void widen(BrickRanges& bricks, const Volume& samples) {
  bricks.octants = std::vector<OctantRanges>();  // gives their memory back; they would have to be widened, too
  const Grid& grid = samples.grid;
  samples.voxels.visit([&](auto scalars) {
    parallelFor(static_cast<std::size_t>(bricks.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      glm::ivec3 brick;
      for (brick.z = static_cast<int>(begin); brick.z < static_cast<int>(end); ++brick.z)
        for (brick.y = 0; brick.y < bricks.dims.y; ++brick.y)
          for (brick.x = 0; brick.x < bricks.dims.x; ++brick.x) {
            const glm::ivec3 low = glm::clamp(brick * brickSide - 1, glm::ivec3(0), grid.dims - 1);
            const glm::ivec3 high = glm::min(brick * brickSide + brickSide - 1, grid.dims - 1);
            double bends = 0.0;
            for (int axis = 0; axis < 3; ++axis) bends += greatestBend(scalars, grid, {low, high}, axis);
            ValueRange& range = bricks.ranges[brickOffset(bricks.dims, brick)];
            const double margin = 2.0 * (1.0 / 8.0 + 1.0 / 12.0) * bends * std::abs(samples.slope);
            range = {range.low - margin, range.high + margin};
          }
    });
  });
}

std::vector<std::uint8_t> refinedOccupied(const FocusIndex& focus, glm::ivec3 dims, int factor) {
  const glm::ivec3 bricks = brickCount(dims * factor);
  const int shift = (factor - 1) / 2;  // cell c of the finer grid lies in the volume's (c + shift) / factor
  std::vector<std::uint8_t> occupied(brickOffset(bricks, {0, 0, bricks.z}), 0);
  parallelFor(static_cast<std::size_t>(bricks.z), 1, [&](std::size_t begin, std::size_t end) {
    glm::ivec3 brick, cell;
    for (brick.z = static_cast<int>(begin); brick.z < static_cast<int>(end); ++brick.z)
      for (brick.y = 0; brick.y < bricks.y; ++brick.y)
        for (brick.x = 0; brick.x < bricks.x; ++brick.x) {
          const glm::ivec3 first = glm::min((brick * brickSide + shift) / factor, dims);
          const glm::ivec3 last = glm::min((brick * brickSide + brickSide - 1 + shift) / factor, dims);
          std::uint8_t& any = occupied[brickOffset(bricks, brick)];
          for (cell.z = first.z; cell.z <= last.z && !any; ++cell.z)
            for (cell.y = first.y; cell.y <= last.y && !any; ++cell.y)
              for (cell.x = first.x; cell.x <= last.x && !any; ++cell.x) any = focus.holds(cell);
        }
  });
  return occupied;
}

}  // namespace fenestra
