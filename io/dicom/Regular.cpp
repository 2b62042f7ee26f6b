#include "io/dicom/Regular.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace {

/// Planes within this many mm of a slice, and pixels that lie so near to those of another slice, take its values as
/// they are: a tenth of positionTolerance.
constexpr double snapDistance = 0.1 * positionTolerance;

/// Pixels [low, high) of a plane.
struct Rectangle {
  glm::ivec2 low{0}, high{0};
  bool empty() const { return low.x >= high.x || low.y >= high.y; }
  Rectangle within(const Rectangle& other) const { return {glm::max(low, other.low), glm::min(high, other.high)}; }
};

/// The samples of a line that a value between them comes from.
struct Taps {
  std::array<int, 4> index{};
  std::array<double, 4> weight{};
  int count = 0;

  void add(int at, double share) {
    for (int i = 0; i < count; ++i)
      if (index[static_cast<std::size_t>(i)] == at) {
        weight[static_cast<std::size_t>(i)] += share;
        return;
      }
    index[static_cast<std::size_t>(count)] = at;
    weight[static_cast<std::size_t>(count++)] = share;
  }
};

/// Between samples 0 … count - 1; `position` may lie outside by the tolerance.
Taps tapsAt(double position, int count, bool cubic) {
  const double at = std::clamp(position, 0.0, static_cast<double>(count - 1));
  const int base = std::min(static_cast<int>(at), std::max(count - 2, 0));
  const double f = at - base;
  Taps taps;
  if (f == 0.0 || count == 1) {
    taps.add(base, 1.0);
  } else if (!cubic) {
    taps.add(base, 1.0 - f);
    taps.add(base + 1, f);
  } else {
    // Beyond the ends the line through the last two samples goes on.
    const auto add = [&](int index, double weight) {
      if (index < 0 || index >= count) {
        const int end = index < 0 ? 0 : count - 1, inner = index < 0 ? 1 : count - 2;
        taps.add(end, 2.0 * weight);
        taps.add(inner, -weight);
      } else {
        taps.add(index, weight);
      }
    };
    add(base, 1.0 + f * f * (1.5 * f - 2.5));
    add(base + 1, f * (0.5 + f * (2.0 - 1.5 * f)));
    add(base - 1, f * (-0.5 + f * (1.0 - 0.5 * f)));
    add(base + 2, f * f * (0.5 * f - 0.5));
  }
  return taps;
}

/// Adds `weight` times a slice, `offset` pixels from the plane's, to the part `rectangle` of a plane that is `width`
/// pixels wide.
template <class T>
void addSlice(const T* slice, glm::ivec2 size, glm::dvec2 offset, bool cubic, double weight, const Rectangle& rectangle,
              int width, double* plane) {
  std::vector<Taps> columns;
  for (int x = rectangle.low.x; x < rectangle.high.x; ++x) columns.push_back(tapsAt(x + offset.x, size.x, cubic));
  std::vector<double> row(static_cast<std::size_t>(size.x));
  for (int y = rectangle.low.y; y < rectangle.high.y; ++y) {
    const Taps rows = tapsAt(y + offset.y, size.y, cubic);
    std::fill(row.begin(), row.end(), 0.0);
    for (int i = 0; i < rows.count; ++i) {
      const T* from = slice + static_cast<std::size_t>(rows.index[static_cast<std::size_t>(i)]) * row.size();
      const double share = weight * rows.weight[static_cast<std::size_t>(i)];
      for (std::size_t x = 0; x < row.size(); ++x) row[x] += share * static_cast<double>(from[x]);
    }
    double* to = plane + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + rectangle.low.x;
    for (const Taps& taps : columns) {
      double sum = 0.0;
      for (int i = 0; i < taps.count; ++i)
        sum += taps.weight[static_cast<std::size_t>(i)] *
               row[static_cast<std::size_t>(taps.index[static_cast<std::size_t>(i)])];
      *to++ += sum;
    }
  }
}

/// A value in the voxels' type: integers rounded, all clamped to the slices' range; NaN stays.
template <class T>
T stored(double value, double least, double greatest) {
  const double clamped = std::isnan(value) ? value : std::clamp(value, least, greatest);
  if constexpr (std::is_integral_v<T>)
    return static_cast<T>(std::round(clamped));
  else
    return static_cast<T>(clamped);
}

}  // namespace

RegularStack::RegularStack(const DicomStack& stack, const SliceLayout& layout, Shape shape, Interpolation interpolation)
    : cubic_(interpolation == Interpolation::Cubic),
      slicesDims_(stack.grid.dims),
      spacing_(stack.grid.spacing.x, stack.grid.spacing.y),
      grid_(stack.grid),
      ownStep_(layout.ownStep) {
  const double depth = layout.offsets.back().z;
  const glm::dvec2 shear = shape == Shape::Sheared ? glm::dvec2(layout.offsets.back()) / depth : glm::dvec2(0.0);
  for (const glm::dvec3& offset : layout.offsets) {
    heights_.push_back(offset.z);
    shifts_.push_back(shear * offset.z - glm::dvec2(offset));
  }
  const glm::dvec3 perHeight = layout.normal + grid_.direction[0] * (shear.x * spacing_.x) +
                               grid_.direction[1] * (shear.y * spacing_.y);  // mm along the stack a mm of the normal
  // A few dense slices among many must not multiply the volume: at most four planes a slice.
  const double step = std::max(ownStep_, 0.25 * depth / static_cast<double>(slicesDims_.z - 1));
  grid_.dims.z = std::max(static_cast<int>(std::lround(depth / step)), 1) + 1;
  grid_.spacing.z = depth / (grid_.dims.z - 1) * glm::length(perHeight);
  grid_.direction[2] = glm::normalize(perHeight);
  growOverSlices();
  addPlanes(depth / (grid_.dims.z - 1));
}

void RegularStack::growOverSlices() {
  glm::dvec2 low(0.0), high(0.0);
  for (glm::dvec2& shift : shifts_) {
    for (int axis = 0; axis < 2; ++axis)
      if (std::abs(shift[axis] - std::round(shift[axis])) * spacing_[axis] <= snapDistance)
        shift[axis] = std::round(shift[axis]);
    low = glm::min(low, -shift);
    high = glm::max(high, -shift);
  }
  const glm::dvec2 first = glm::floor(low), grown = glm::ceil(high) - first;
  // Grids beyond this limit are refused before they are filled; the sum stays within int.
  constexpr double mostPixels = 1e6;
  grid_.dims.x += static_cast<int>(std::min(grown.x, mostPixels));
  grid_.dims.y += static_cast<int>(std::min(grown.y, mostPixels));
  for (glm::dvec2& shift : shifts_) shift += first;
  for (int axis = 0; axis < 2; ++axis) grid_.origin += grid_.direction[axis] * (first[axis] * spacing_[axis]);
}

void RegularStack::addPlanes(double step) {
  for (int z = 0; z < grid_.dims.z; ++z) {
    planes_.push_back(planeAt(z * step));
    const std::vector<Source>& beside = planes_.back().linear;
    if (beside.size() == 2 && heights_[beside[1].slice] - heights_[beside[0].slice] > 1.5 * ownStep_)
      interpolatedPlanes_.push_back(z);
  }
}

RegularStack::Plane RegularStack::planeAt(double height) const {
  const std::vector<double>& at = heights_;
  const auto above = std::upper_bound(at.begin(), at.end(), height);
  const std::size_t i = std::clamp<std::size_t>(static_cast<std::size_t>(above - at.begin()), 1, at.size() - 1) - 1;
  const double gap = at[i + 1] - at[i], f = (height - at[i]) / gap;
  Plane plane;
  if (f * gap <= snapDistance)
    plane.linear = {{i, 1.0}};
  else if ((1.0 - f) * gap <= snapDistance)
    plane.linear = {{i + 1, 1.0}};
  else
    plane.linear = {{i, 1.0 - f}, {i + 1, f}};
  plane.all = plane.linear;
  if (!cubic_ || plane.linear.size() < 2) return plane;

  // Hermite basis; the slopes at both slices are weighted sums of values, too.
  plane.all = {{i, (1.0 + 2.0 * f) * (1.0 - f) * (1.0 - f)}, {i + 1, f * f * (3.0 - 2.0 * f)}};
  const auto add = [&](std::size_t slice, double weight) {
    for (Source& source : plane.all)
      if (source.slice == slice) {
        source.weight += weight;
        return;
      }
    plane.all.push_back({slice, weight});
  };
  const auto addDifference = [&](std::size_t slice, double weight) {  // (value of slice + 1) - (value of slice), per mm
    const double distance = at[slice + 1] - at[slice];
    add(slice + 1, weight / distance);
    add(slice, -weight / distance);
  };
  const auto addSlope = [&](std::size_t slice, double weight) {
    if (slice == 0) return addDifference(0, weight);
    if (slice + 1 == at.size()) return addDifference(slice - 1, weight);
    const double before = at[slice] - at[slice - 1], after = at[slice + 1] - at[slice];
    addDifference(slice - 1, weight * after / (before + after));
    addDifference(slice, weight * before / (before + after));
  };
  addSlope(i, gap * f * (1.0 - f) * (1.0 - f));
  addSlope(i + 1, gap * f * f * (f - 1.0));
  return plane;
}

RegularStack::Result RegularStack::resample(const Voxels& slices, bool lowest,
                                            const std::function<void()>& step) const {
  const glm::ivec2 size(slicesDims_), planeSize(grid_.dims);
  const auto pixels = [](glm::ivec2 dims) {
    return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y);
  };
  // Pixels of a plane that every one of the slices covers.
  const auto coveredBy = [&](const std::vector<Source>& sources) {
    Rectangle covered{{0, 0}, planeSize};
    for (const Source& source : sources) {
      const glm::dvec2 offset = shifts_[source.slice], slack = snapDistance / spacing_;
      covered = covered.within(
          {glm::ivec2(glm::ceil(-offset - slack)), glm::ivec2(glm::floor(glm::dvec2(size - 1) - offset + slack)) + 1});
    }
    return covered;
  };
  Result result{Voxels(slices.type(), grid_.voxelCount())};
  std::atomic<std::size_t> filled = 0;
  slices.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::element_type>;
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const T scalar : scalars)
      if (std::isfinite(static_cast<double>(scalar))) {
        least = std::min(least, static_cast<double>(scalar));
        greatest = std::max(greatest, static_cast<double>(scalar));
      }
    if (least > greatest) least = greatest = 0.0;
    const T nothing = static_cast<T>(lowest ? least : greatest);
    T* to = result.voxels.as<T>().data();
    parallelFor(planes_.size(), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<double> values(pixels(planeSize));
      for (std::size_t z = begin; z < end; ++z) {
        step();
        T* plane = to + z * values.size();
        std::fill(plane, plane + values.size(), nothing);
        const auto fill = [&](const std::vector<Source>& sources, const Rectangle& covered) {
          std::fill(values.begin(), values.end(), 0.0);
          for (const Source& source : sources)
            addSlice(scalars.data() + source.slice * pixels(size), size, shifts_[source.slice], cubic_, source.weight,
                     covered, planeSize.x, values.data());
          for (int y = covered.low.y; y < covered.high.y; ++y)
            for (int x = covered.low.x; x < covered.high.x; ++x) {
              const std::size_t at =
                  static_cast<std::size_t>(y) * static_cast<std::size_t>(planeSize.x) + static_cast<std::size_t>(x);
              plane[at] = stored<T>(values[at], least, greatest);
            }
        };
        const Rectangle inner = coveredBy(planes_[z].linear), full = coveredBy(planes_[z].all);
        if (!inner.empty()) {
          fill(planes_[z].linear, inner);
          filled += pixels(inner.high - inner.low);
        }
        // Where a slice further away has no pixel, the line between the nearest two must do.
        if (cubic_ && planes_[z].all.size() > 1 && !full.empty()) fill(planes_[z].all, full);
      }
    });
  });
  result.empty = result.voxels.count() - filled;
  return result;
}

}  // namespace fenestra::io
