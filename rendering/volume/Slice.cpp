#include "rendering/volume/Slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// A direction across a picture: its index axis, and whether it runs backwards.
struct SliceSide {
  int axis = 0;
  glm::dvec3 step{0.0};   ///< world, mm per voxel, along the picture's side
  bool reversed = false;  ///< pixel 0 is the axis's last voxel
};

SliceSide side(const Grid& grid, int axis, glm::dvec3 towards) {
  const glm::dvec3 step = grid.direction[axis] * grid.spacing[axis];
  const bool reversed = glm::dot(step, towards) < 0.0;
  return {axis, reversed ? -step : step, reversed};
}

/// Index positions of a slice's pixels.
struct IndexWalk {
  glm::dvec3 start, right, down;

  glm::dvec3 at(int i, int j) const { return start + static_cast<double>(i) * right + static_cast<double>(j) * down; }
};

IndexWalk indexWalk(const Grid& grid, const SliceGeometry& geometry, int slice) {
  const glm::dmat3 linear(grid.indexFromWorld());
  // Subtracting the origins first keeps the precision where both are metres away.
  return {linear * (geometry.worldFromPixel(0, 0, slice) - grid.origin), linear * geometry.right,
          linear * geometry.down};
}

bool isNearInteger(glm::dvec3 v, double tolerance) {
  return glm::all(glm::lessThanEqual(glm::abs(v - glm::round(v)), glm::dvec3(tolerance)));
}

/// Whether every pixel of a slice is the centre of a voxel, to a thousandth of a voxel across the whole picture.
bool liesOnVoxels(const IndexWalk& walk, const SliceGeometry& geometry) {
  constexpr double tolerance = 1e-3;
  return isNearInteger(walk.start, tolerance) && isNearInteger(walk.right, tolerance / geometry.width) &&
         isNearInteger(walk.down, tolerance / geometry.height);
}

/// Whether an index position lies in the grid's box. Written so that a position that is no number is outside as well.
bool isInside(const Grid& grid, glm::dvec3 position) {
  return glm::all(glm::greaterThanEqual(position, glm::dvec3(-0.5))) &&
         glm::all(glm::lessThanEqual(position, glm::dvec3(grid.dims) - 0.5));
}

std::size_t pixelCount(const SliceGeometry& geometry) {
  return static_cast<std::size_t>(geometry.width) * static_cast<std::size_t>(geometry.height);
}

/// Calls pixel(index of the pixel, index position in the grid) for all pixels of a slice, on all cores.
template <class F>
void forEachPixel(const SliceGeometry& geometry, const IndexWalk& walk, F&& pixel) {
  const auto width = static_cast<std::size_t>(geometry.width);
  constexpr std::size_t worthAThread = 1 << 16;
  parallelFor(static_cast<std::size_t>(geometry.height), worthAThread / std::max<std::size_t>(width, 1) + 1,
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t j = begin; j < end; ++j)
                  for (std::size_t i = 0; i < width; ++i)
                    pixel(j * width + i, walk.at(static_cast<int>(i), static_cast<int>(j)));
              });
}

/// As Volume::sample(), of stored values, without asking for the type and the place of each voxel anew: a slice of
/// half a million pixels takes a third of the time.
template <class T>
class TrilinearReader {
 public:
  TrilinearReader(const Grid& grid, std::span<const T> scalars)
      : grid_(grid),
        scalars_(scalars),
        last_(grid.dims - 1),
        row_(grid.dims.y > 1 ? static_cast<std::size_t>(grid.dims.x) : 0),
        plane_(grid.dims.z > 1 ? static_cast<std::size_t>(grid.dims.x) * static_cast<std::size_t>(grid.dims.y) : 0) {}

  double at(glm::dvec3 index) const {
    // Voxels that are no numbers count only where they have a weight.
    if constexpr (std::is_floating_point_v<T>) {
      return interpolated(grid_, index,
                          [&](glm::ivec3 voxel) { return static_cast<double>(scalars_[grid_.offset(voxel)]); });
    } else {
      const glm::dvec3 clamped = glm::clamp(index, glm::dvec3(0.0), last_);
      const glm::ivec3 base = glm::min(glm::ivec3(clamped), glm::max(grid_.dims - 2, 0));
      const glm::dvec3 f = clamped - glm::dvec3(base);
      const T* const first = scalars_.data() + base.x +
                             static_cast<std::size_t>(base.y) * static_cast<std::size_t>(grid_.dims.x) +
                             static_cast<std::size_t>(base.z) * static_cast<std::size_t>(grid_.dims.x) *
                                 static_cast<std::size_t>(grid_.dims.y);
      const std::size_t right = grid_.dims.x > 1 ? 1 : 0;
      const auto along = [&](const T* at) {
        const auto low = static_cast<double>(at[0]);
        return low + f.x * (static_cast<double>(at[right]) - low);
      };
      const auto across = [&](const T* at) {
        const double low = along(at);
        return low + f.y * (along(at + row_) - low);
      };
      const double low = across(first);
      return low + f.z * (across(first + plane_) - low);
    }
  }

 private:
  const Grid& grid_;
  const std::span<const T> scalars_;
  const glm::dvec3 last_;
  const std::size_t row_, plane_;  ///< voxels to the next one along y and z
};

}  // namespace

glm::dvec3 SliceGeometry::worldFromPixel(double i, double j, double slice) const {
  return origin + i * right + j * down + slice * normal;
}

glm::dvec3 SliceGeometry::pixelFromWorld(glm::dvec3 world) const {
  return glm::inverse(glm::dmat3(right, down, normal)) * (world - origin);
}

int SliceGeometry::sliceAt(double mm) const {
  const int along = plane == SlicePlane::Axial ? 2 : plane == SlicePlane::Sagittal ? 0 : 1;
  const double first = worldFromPixel(0.5 * (width - 1), 0.5 * (height - 1), 0.0)[along];
  const double slice = std::round((mm - first) / normal[along]);
  if (!(slice > 0.0)) return 0;
  return slice < count ? static_cast<int>(slice) : count - 1;
}

SliceGeometry sliceGeometry(const Grid& grid, SlicePlane plane) {
  const glm::ivec3 axes = grid.patientAxes();
  const glm::dvec3 left(1.0, 0.0, 0.0), posterior(0.0, 1.0, 0.0), superior(0.0, 0.0, 1.0);

  SliceSide right, down, normal;
  switch (plane) {
    case SlicePlane::Axial:
      right = side(grid, axes.x, left);
      down = side(grid, axes.y, posterior);
      normal = side(grid, axes.z, superior);
      break;
    case SlicePlane::Sagittal:
      right = side(grid, axes.y, posterior);
      down = side(grid, axes.z, -superior);
      normal = side(grid, axes.x, left);
      break;
    case SlicePlane::Coronal:
      right = side(grid, axes.x, left);
      down = side(grid, axes.z, -superior);
      normal = side(grid, axes.y, posterior);
      break;
  }

  SliceGeometry geometry;
  geometry.plane = plane;
  geometry.axis = normal.axis;
  geometry.count = grid.dims[normal.axis];
  geometry.width = grid.dims[right.axis];
  geometry.height = grid.dims[down.axis];
  geometry.normal = normal.step;

  glm::dvec3 first = grid.origin;
  for (const SliceSide& s : {right, down, normal})
    if (s.reversed) first -= s.step * static_cast<double>(grid.dims[s.axis] - 1);

  // A sheared plane keeps the side nearer to its patient axis (the table's travel under a tilted gantry). The other
  // side loses its component along the first, and the picture grows along the first by the shift of the shear. Columns
  // (or rows) still fall on those of the voxels; values are interpolated along them only.
  const auto alignment = [](const SliceSide& s) {
    const glm::dvec3 unit = glm::abs(glm::normalize(s.step));
    return std::max({unit.x, unit.y, unit.z});
  };
  const bool keepDown = alignment(down) >= alignment(right);
  SliceSide& kept = keepDown ? down : right;
  SliceSide& turned = keepDown ? right : down;
  int& keptPixels = keepDown ? geometry.height : geometry.width;
  const int turnedPixels = keepDown ? geometry.width : geometry.height;
  const double shiftPerPixel = glm::dot(turned.step, kept.step) / glm::dot(kept.step, kept.step);
  const double shift = shiftPerPixel * (turnedPixels - 1);
  // Direction cosines are often stored with six digits, so a shift of less than half a pixel does not count as shear.
  if (std::abs(shift) > 0.5) {
    turned.step -= shiftPerPixel * kept.step;
    keptPixels += static_cast<int>(std::ceil(std::abs(shift)));
    if (shift < 0.0) first += std::floor(shift) * kept.step;
  }
  geometry.origin = first;
  geometry.right = right.step;
  geometry.down = down.step;
  return geometry;
}

std::vector<float> sliceValues(const Volume& volume, const SliceGeometry& geometry, int slice) {
  std::vector<float> values(pixelCount(geometry), std::numeric_limits<float>::quiet_NaN());
  const IndexWalk walk = indexWalk(volume.grid, geometry, slice);
  if (liesOnVoxels(walk, geometry)) {
    volume.voxels.visit([&](auto scalars) {
      forEachPixel(geometry, walk, [&](std::size_t pixel, glm::dvec3 position) {
        const glm::ivec3 index(glm::round(position));
        if (!volume.grid.contains(index)) return;
        const auto stored = static_cast<double>(scalars[volume.grid.offset(index)]);
        values[pixel] = static_cast<float>(volume.slope * stored + volume.intercept);
      });
    });
    return values;
  }
  volume.voxels.visit([&](auto scalars) {
    const TrilinearReader reader(volume.grid, scalars);
    forEachPixel(geometry, walk, [&](std::size_t pixel, glm::dvec3 position) {
      if (isInside(volume.grid, position))
        values[pixel] = static_cast<float>(volume.slope * reader.at(position) + volume.intercept);
    });
  });
  return values;
}

SliceSampler::SliceSampler(const Volume& volume, const SliceGeometry& geometry, int slice) : volume_(volume) {
  const IndexWalk walk = indexWalk(volume.grid, geometry, slice);
  start_ = walk.start;
  right_ = walk.right;
  down_ = walk.down;
  onVoxels_ = liesOnVoxels(walk, geometry);
}

double SliceSampler::at(int i, int j) const {
  const glm::dvec3 position = IndexWalk{start_, right_, down_}.at(i, j);
  if (onVoxels_) {
    const glm::ivec3 index(glm::round(position));
    return volume_.grid.contains(index) ? volume_.value(index) : std::numeric_limits<double>::quiet_NaN();
  }
  return isInside(volume_.grid, position) ? volume_.sample(position) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::uint16_t> sliceLabels(const LabelMap& labels, const SliceGeometry& geometry, int slice) {
  std::vector<std::uint16_t> values(pixelCount(geometry), 0);
  labels.voxels.visit([&](auto scalars) {
    forEachPixel(geometry, indexWalk(labels.grid, geometry, slice), [&](std::size_t pixel, glm::dvec3 position) {
      const glm::ivec3 index(glm::round(position));
      if (labels.grid.contains(index)) values[pixel] = static_cast<std::uint16_t>(scalars[labels.grid.offset(index)]);
    });
  });
  return values;
}

std::vector<std::uint8_t> windowed(const std::vector<float>& values, WindowLevel window, bool lowIsWhite) {
  const double low = window.level - 0.5 * window.width;
  const double scale = window.width > 0.0 ? 255.0 / window.width : std::numeric_limits<double>::max();
  std::vector<std::uint8_t> grey(values.size());
  std::transform(values.begin(), values.end(), grey.begin(), [&](float value) -> std::uint8_t {
    if (std::isnan(value)) return 0;
    const double level = std::clamp((static_cast<double>(value) - low) * scale, 0.0, 255.0);
    return static_cast<std::uint8_t>((lowIsWhite ? 255.0 - level : level) + 0.5);
  });
  return grey;
}

std::string orientationLetters(glm::dvec3 direction) {
  constexpr const char* positive = "LPS";
  constexpr const char* negative = "RAI";
  const glm::dvec3 size = glm::abs(direction);
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return size[a] > size[b]; });
  std::string letters;
  for (const int axis : order)
    if (size[axis] > 0.25 * size[order[0]]) letters += (direction[axis] < 0.0 ? negative : positive)[axis];
  return letters;
}

}  // namespace fenestra
