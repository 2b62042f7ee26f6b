#include "rendering/gpu/RefinedVolume.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "rendering/gpu/RefinedSampler.h"
#include "rendering/gpu/UploadSlabs.h"
#include "rendering/gpu/WideRows.h"
#include "rendering/scene/Lighting.h"

namespace fenestra {
namespace {

constexpr IndexBox noVoxels{glm::ivec3(0), glm::ivec3(-1)};

bool fitsSixteenBits(const Volume& volume) {
  const ScalarType type = volume.voxels.type();
  return type != ScalarType::Float32 && type != ScalarType::Float64 &&
         (volume.range.high - volume.range.low) / std::abs(volume.slope) <= 65535.0;
}

template <class Stored, class Wide>
inline void takeDifferences(const Stored* row, std::ptrdiff_t stride, std::size_t count, Wide* greatest) {
  for (std::size_t i = 0; i < count; ++i) {
    const Stored* at = row + i;
    const Wide bend = static_cast<Wide>(at[-stride]) - 2 * static_cast<Wide>(at[0]) + static_cast<Wide>(at[stride]);
    greatest[i] = std::max(greatest[i], bend < 0 ? -bend : bend);
  }
}

/// Raises the greatest second difference at each x to the row's there.
template <class Stored, class Wide>
void takeBends(const Stored* row, std::ptrdiff_t stride, std::size_t count, Wide* greatest) {
  takeDifferences(row, stride, count, greatest);
}
FENESTRA_WIDE_ROWS void takeBends(const std::uint16_t* row, std::ptrdiff_t stride, std::size_t count,
                                  std::int32_t* greatest) {
  takeDifferences(row, stride, count, greatest);
}

/// The greatest second differences along each axis at the samples of a row of bricks, as stored: at each x, over the
/// samples of the bricks' layers and those before them.
template <class Stored>
class RowBends {
 public:
  using Wide = std::conditional_t<std::is_integral_v<Stored> && sizeof(Stored) <= 2, std::int32_t, double>;

  RowBends(std::span<const Stored> scalars, const Grid& grid) : scalars_(scalars), grid_(grid) {
    for (std::vector<Wide>& bends : greatest_) bends.resize(static_cast<std::size_t>(grid.dims.x));
  }

  /// Finds the greatest bends of the row of bricks at y and z.
  void look(int y, int z) {
    for (std::vector<Wide>& bends : greatest_) std::fill(bends.begin(), bends.end(), Wide{0});
    const glm::ivec3 dims = grid_.dims;
    const auto first = [](int brick) { return std::max(brick * brickSide - 1, 0); };
    const auto last = [](int brick, int count) { return std::min(brick * brickSide + brickSide, count) - 1; };
    for (int k = first(z); k <= last(z, dims.z); ++k)
      for (int j = first(y); j <= last(y, dims.y); ++j) {
        if (dims.x > 2) take(0, {1, j, k}, dims.x - 2);
        if (j > 0 && j < dims.y - 1) take(1, {0, j, k}, dims.x);
        if (k > 0 && k < dims.z - 1) take(2, {0, j, k}, dims.x);
      }
  }
  /// The sum over the axes, in a brick of the row.
  double sumIn(int brick) const {
    const auto begin = static_cast<std::ptrdiff_t>(std::clamp(brick * brickSide - 1, 0, grid_.dims.x - 1));
    const auto end = static_cast<std::ptrdiff_t>(std::min(brick * brickSide + brickSide, grid_.dims.x));
    double sum = 0.0;
    for (const std::vector<Wide>& bends : greatest_)
      if (begin < end) sum += static_cast<double>(*std::max_element(bends.begin() + begin, bends.begin() + end));
    return sum;
  }

 private:
  void take(int axis, glm::ivec3 from, int count) {
    glm::ivec3 next(0);
    next[axis] = 1;
    const auto stride = static_cast<std::ptrdiff_t>(grid_.offset(next));
    takeBends(scalars_.data() + grid_.offset(from), stride, static_cast<std::size_t>(count),
              greatest_[static_cast<std::size_t>(axis)].data() + from.x);
  }

  std::span<const Stored> scalars_;
  const Grid& grid_;
  std::array<std::vector<Wide>, 3> greatest_;  ///< by axis
};

/// store(plane, y, room, row) samples a row of a plane.
template <class T, class Store>
void sample(Volume& volume, const RefinedSampler& sampler, const Store& store) {
  const glm::ivec3 dims = volume.grid.dims;
  parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
    RefinedSampler::Room room;
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z) {
      const std::vector<double> plane = sampler.plane(z);
      for (int y = 0; y < dims.y; ++y)
        store(plane, y, room,
              volume.voxels.as<T>().subspan(volume.grid.offset({0, y, z}), static_cast<std::size_t>(dims.x)));
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
  const RefinedSampler sampler(spline, factor);
  const auto [low, high] = spline.range();
  if (narrow) {
    const double last = 65535.0;
    result->slope = high > low ? (high - low) / last : 1.0;
    result->intercept = low;
    const double perReal = 1.0 / result->slope;
    sample<std::uint16_t>(
        *result, sampler,
        [&, least = low](const std::vector<double>& plane, int y, RefinedSampler::Room& room,
                         std::span<std::uint16_t> row) { sampler.row(plane, y, room, least, perReal, row); });
  } else {
    sample<float>(*result, sampler,
                  [&, least = low, greatest = high](const std::vector<double>& plane, int y, RefinedSampler::Room& room,
                                                    std::span<float> row) {
                    std::vector<double> samples(row.size());
                    sampler.row(plane, y, room, samples);
                    std::transform(samples.begin(), samples.end(), row.begin(), [&](double value) {
                      return static_cast<float>(std::clamp(value, least, greatest));
                    });
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
  const auto gated = [&](glm::dvec3 gradient) {
    const glm::dvec3 g = worldFromIndexGradient * gradient;
    const double length = glm::length(g);
    if (!(length > lighting::gradientGateLow)) return glm::dvec3(0.0);
    return g * (glm::smoothstep(lighting::gradientGateLow, lighting::gradientGateHigh, length) / length);
  };
  return SplineVectors(volume.grid.dims, SplineVectors::ByRows{}, [&](int y, int z, std::span<glm::dvec3> row) {
    voxelGradients(spline, y, z, row);
    std::transform(row.begin(), row.end(), row.begin(), gated);
  });
}

gl::Texture makeCoefficients(const SplineVectors& normals) {
  const glm::ivec3 size = normals.part(0).size();
  gl::Texture texture = gl::Texture::make3D(gl::Format::RGB10A2, size);
  uploadBySlabs<std::uint32_t>(texture, planeSize(size), [&](int z, std::uint32_t* plane) {
    const auto width = static_cast<std::size_t>(size.x);
    for (int y = 0; y < size.y; ++y, plane += width)
      for (int axis = 0; axis < 3; ++axis) setTenBits({normals.part(axis).row(y - 1, z - 1), width}, 10 * axis, plane);
  });
  return texture;
}

GradientTexture refinedGradientFor(glm::ivec3 dims, int factor, const std::optional<IndexBox>& box) {
  const IndexBox in = box.value_or(noVoxels);
  GradientTexture result;
  result.origin = glm::max(in.low - 1, glm::ivec3(0));
  result.texture =
      gl::Texture::make3D(gl::Format::RGB10A2, glm::min(in.high + 1, dims * factor - 1) - result.origin + 1);
  return result;
}

void fillRefinedGradient(GradientTexture& gradient, const SplineVectors& normals, int factor,
                         const std::optional<IndexBox>& box) {
  const auto [low, high] = box.value_or(noVoxels);
  const glm::ivec3 size = gradient.texture.size(), origin = gradient.origin;
  const std::array<RefinedSampler, 3> samplers{RefinedSampler(normals.part(0), factor),
                                               RefinedSampler(normals.part(1), factor),
                                               RefinedSampler(normals.part(2), factor)};
  constexpr std::uint32_t flat = 511u | 511u << 10 | 511u << 20;
  uploadBySlabs<
      std::uint32_t>(gradient.texture, planeSize(size), [&, low = low, high = high](int depth, std::uint32_t* texels) {
    const int z = origin.z + depth;
    if (z < low.z || z > high.z) {
      std::fill_n(texels, planeSize(size), flat);
      return;
    }
    const std::array<std::vector<double>, 3> planes{samplers[0].plane(z), samplers[1].plane(z), samplers[2].plane(z)};
    const auto width = static_cast<std::size_t>(size.x), first = static_cast<std::size_t>(low.x - origin.x),
               count = static_cast<std::size_t>(high.x - low.x + 1);
    RefinedSampler::Room room;
    for (int y = origin.y; y < origin.y + size.y; ++y, texels += width) {
      const bool isIn = y >= low.y && y <= high.y;
      std::fill_n(texels, isIn ? first : width, flat);
      if (!isIn) continue;
      samplers[0].normals(planes, y, room, low.x, {texels + first, count});
      std::fill(texels + first + count, texels + width, flat);
    }
  });
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
  assert(bricks.octants.empty());
  const Grid& grid = samples.grid;
  samples.voxels.visit([&](auto scalars) {
    parallelFor(static_cast<std::size_t>(bricks.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      RowBends<std::remove_const_t<typename decltype(scalars)::element_type>> bends(scalars, grid);
      glm::ivec3 brick;
      for (brick.z = static_cast<int>(begin); brick.z < static_cast<int>(end); ++brick.z)
        for (brick.y = 0; brick.y < bricks.dims.y; ++brick.y) {
          bends.look(brick.y, brick.z);
          for (brick.x = 0; brick.x < bricks.dims.x; ++brick.x) {
            ValueRange& range = bricks.ranges[brickOffset(bricks.dims, brick)];
            const double margin = 2.0 * (1.0 / 8.0 + 1.0 / 12.0) * bends.sumIn(brick.x) * std::abs(samples.slope);
            range = {range.low - margin, range.high + margin};
          }
        }
    });
  });
}

std::vector<std::uint8_t> refinedOccupied(const FocusIndex& focus, glm::ivec3 dims, int factor) {
  const glm::ivec3 bricks = brickCount(dims * factor);
  const int shift = (factor - 1) / 2;  // cell c of the finer grid lies in the volume's (c + shift) / factor
  const auto firstCell = [&](glm::ivec3 brick) { return glm::min((brick * brickSide + shift) / factor, dims); };
  const auto lastCell = [&](glm::ivec3 brick) {
    return glm::min((brick * brickSide + brickSide - 1 + shift) / factor, dims);
  };
  // Most rows of the volume's bricks hold nothing of a label.
  std::vector<std::uint8_t> rows(planeSize({focus.bricks.y, focus.bricks.z, 1}));
  for (std::size_t row = 0, width = static_cast<std::size_t>(focus.bricks.x); row < rows.size(); ++row)
    rows[row] = std::any_of(focus.slots.begin() + static_cast<std::ptrdiff_t>(row * width),
                            focus.slots.begin() + static_cast<std::ptrdiff_t>((row + 1) * width),
                            [](std::uint32_t slot) { return slot != 0; });
  const auto holdsRow = [&](glm::ivec3 first, glm::ivec3 last) {
    for (int z = first.z / brickSide; z <= last.z / brickSide; ++z)
      for (int y = first.y / brickSide; y <= last.y / brickSide; ++y)
        if (rows[brickOffset({focus.bricks.y, focus.bricks.z, 1}, {y, z, 0})]) return true;
    return false;
  };
  std::vector<std::uint8_t> occupied(brickOffset(bricks, {0, 0, bricks.z}), 0);
  parallelFor(static_cast<std::size_t>(bricks.z), 1, [&](std::size_t begin, std::size_t end) {
    glm::ivec3 brick;
    for (brick.z = static_cast<int>(begin); brick.z < static_cast<int>(end); ++brick.z)
      for (brick.y = 0; brick.y < bricks.y; ++brick.y) {
        brick.x = 0;
        if (!holdsRow(firstCell(brick), lastCell(brick))) continue;
        for (; brick.x < bricks.x; ++brick.x)
          occupied[brickOffset(bricks, brick)] = focus.holdsAny({firstCell(brick), lastCell(brick)});
      }
  });
  return occupied;
}

}  // namespace fenestra
