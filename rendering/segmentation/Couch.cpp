#include "rendering/segmentation/Couch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "rendering/volume/DistanceTransform.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr double cellSide = 2.0;  // mm
constexpr std::size_t mostCells = std::size_t{1} << 24;
constexpr double solidValue = -200.0, matterValue = -500.0;  // HU: below fat; half way from air to water
constexpr double airyValue = -920.0;                         // HU: half way from air to the lung
constexpr double openingRadius = 6.0, regrowth = 4.0;        // mm
constexpr double leastPart = 1000.0;                         // mm³ of a part's core
constexpr double leastMean = -150.0, greatestMean = 700.0;   // HU of a part
constexpr double slabThickness = 30.0, slabLength = 200.0;   // mm
constexpr double deepestSlab = 0.5 * slabThickness;          // mm from its surface to its middle
constexpr double appendageReach = 40.0;                      // mm
constexpr int shellCells = 2;

/// The volume's cells.
struct Cells {
  glm::ivec3 stride{1}, dims{0};
  glm::dvec3 spacing{1.0};                   ///< mm
  std::vector<std::int16_t> mean, greatest;  ///< HU

  std::size_t count() const { return mean.size(); }
  glm::ivec3 at(std::size_t i) const {
    const auto x = static_cast<std::size_t>(dims.x), y = static_cast<std::size_t>(dims.y);
    return {static_cast<int>(i % x), static_cast<int>(i / x % y), static_cast<int>(i / (x * y))};
  }
  std::size_t offset(glm::ivec3 c) const {
    return static_cast<std::size_t>(c.x) +
           static_cast<std::size_t>(dims.x) *
               (static_cast<std::size_t>(c.y) + static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(c.z));
  }
  bool contains(glm::ivec3 c) const {
    return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, dims));
  }
  double cellVolume() const { return spacing.x * spacing.y * spacing.z; }
};

using Flags = std::vector<std::uint8_t>;

Cells layOut(const Grid& grid) {
  Cells cells;
  for (int axis = 0; axis < 3; ++axis)
    cells.stride[axis] = std::max(1, static_cast<int>(std::lround(cellSide / grid.spacing[axis])));
  const auto dims = [&] { return (grid.dims + cells.stride - 1) / cells.stride; };
  const auto count = [&] {
    const glm::ivec3 d = dims();
    return static_cast<std::size_t>(d.x) * static_cast<std::size_t>(d.y) * static_cast<std::size_t>(d.z);
  };
  while (count() > mostCells) {
    int finest = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (grid.spacing[axis] * cells.stride[axis] < grid.spacing[finest] * cells.stride[finest]) finest = axis;
    ++cells.stride[finest];
  }
  cells.dims = dims();
  cells.spacing = grid.spacing * glm::dvec3(cells.stride);
  cells.mean.resize(count());
  cells.greatest.resize(count());
  return cells;
}

constexpr double leastSeen = -3000.0, greatestSeen = 30000.0;  // HU

/// Sums and greatest values of rows of voxels, by voxel; what is no number counts as air.
template <class T>
class RowSums {
 public:
  explicit RowSums(const Volume& volume)
      : volume_(volume),
        sums_(static_cast<std::size_t>(volume.grid.dims.x)),
        peaks_(static_cast<std::size_t>(volume.grid.dims.x)) {}

  void clear() {
    std::fill(sums_.begin(), sums_.end(), 0.0);
    std::fill(peaks_.begin(), peaks_.end(), airValue);
  }
  void add(const T* row) {
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      double value = volume_.slope * static_cast<double>(row[i]) + volume_.intercept;
      if constexpr (std::is_floating_point_v<T>) value = std::isnan(value) ? airValue : value;
      value = std::clamp(value, leastSeen, greatestSeen);
      sums_[i] += value;
      peaks_[i] = std::max(peaks_[i], value);
    }
  }
  double sum(std::size_t i) const { return sums_[i]; }
  double peak(std::size_t i) const { return peaks_[i]; }

 private:
  const Volume& volume_;
  std::vector<double> sums_, peaks_;
};

/// RowSums of scalars of at most 16 bits whose values are whole numbers of HU.
template <class T>
class WholeRowSums {
 public:
  explicit WholeRowSums(const Volume& volume)
      : intercept_(static_cast<int>(volume.intercept)),
        sums_(static_cast<std::size_t>(volume.grid.dims.x)),
        peaks_(static_cast<std::size_t>(volume.grid.dims.x)) {}

  /// Whether sums of so many rows are exact.
  static bool fits(const Volume& volume, int rows) {
    return volume.slope == 1.0 && volume.intercept == std::round(volume.intercept) &&
           std::abs(volume.intercept) <= 65536.0 && rows <= 1024 && volume.range.low >= leastSeen &&
           volume.range.high <= greatestSeen;
  }
  void clear() {
    rows_ = 0;
    std::fill(sums_.begin(), sums_.end(), 0);
    std::fill(peaks_.begin(), peaks_.end(), std::numeric_limits<T>::lowest());
  }
  void add(const T* row) {
    ++rows_;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      sums_[i] += static_cast<std::int32_t>(row[i]);
      peaks_[i] = std::max(peaks_[i], row[i]);
    }
  }
  double sum(std::size_t i) const { return sums_[i] + rows_ * intercept_; }
  double peak(std::size_t i) const { return std::max(airValue, static_cast<double>(peaks_[i]) + intercept_); }

 private:
  int intercept_, rows_ = 0;
  std::vector<std::int32_t> sums_;
  std::vector<T> peaks_;
};

/// Fills the rows [begin, end) of cells along z.
template <class T, class Sums>
void fillCells(const Volume& volume, std::size_t begin, std::size_t end, Sums sums, Cells& cells) {
  const Grid& grid = volume.grid;
  const T* scalars = volume.voxels.template as<T>().data();
  for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
    for (int y = 0; y < cells.dims.y; ++y) {
      const glm::ivec3 low = glm::ivec3(0, y, z) * cells.stride, high = glm::min(low + cells.stride, grid.dims);
      // The rows of voxels are joined first, which vectorizes.
      sums.clear();
      for (int k = low.z; k < high.z; ++k)
        for (int j = low.y; j < high.y; ++j) sums.add(scalars + grid.offset({0, j, k}));
      const std::size_t first = cells.offset({0, y, z});
      for (int x = 0; x < cells.dims.x; ++x) {
        const int from = x * cells.stride.x, to = std::min(from + cells.stride.x, grid.dims.x);
        double sum = 0.0, greatest = airValue;
        for (auto i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i) {
          sum += sums.sum(i);
          greatest = std::max(greatest, sums.peak(i));
        }
        const double joined = static_cast<double>(to - from) * (high.y - low.y) * (high.z - low.z);
        cells.mean[first + static_cast<std::size_t>(x)] = static_cast<std::int16_t>(sum / joined);
        cells.greatest[first + static_cast<std::size_t>(x)] = static_cast<std::int16_t>(greatest);
      }
    }
}

/// Means and greatest values.
Cells cellsOf(const Volume& volume) {
  Cells cells = layOut(volume.grid);
  volume.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::value_type>;
    parallelFor(static_cast<std::size_t>(cells.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      if constexpr (std::is_integral_v<T> && sizeof(T) <= 2)
        if (WholeRowSums<T>::fits(volume, cells.stride.y * cells.stride.z))
          return fillCells<T>(volume, begin, end, WholeRowSums<T>(volume), cells);
      fillCells<T>(volume, begin, end, RowSums<T>(volume), cells);
    });
  });
  return cells;
}

/// mm from each cell's centre to that of the nearest cell of the set; infinite where that is farther than `reach`.
std::vector<float> distanceTo(const Cells& cells, const Flags& set, double reach) {
  return distancesTo(set, {.dims = cells.dims, .spacing = cells.spacing}, {.points = cells.dims}, reach);
}

/// The cells of which holds(i) is true.
template <class Holds>
Flags flagsWhere(const Cells& cells, const Holds& holds) {
  Flags flags(cells.count());
  parallelFor(flags.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) flags[i] = holds(i);
  });
  return flags;
}

/// Calls take(cells of the part) for each 26-connected part of `set`, in memory order of their first cells. Clears
/// `set`.
template <class Take>
void forEachPart(const Cells& cells, Flags& set, Take&& take) {
  std::vector<std::uint32_t> part;
  struct Stretch {
    int begin, end, y, z;  ///< cells [begin, end) of a row
  };
  std::vector<Stretch> open;
  // Adds the cells of [from, to) of a row to the part, with those before and behind that touch them.
  const auto addRow = [&](int from, int to, int y, int z) {
    if (y < 0 || z < 0 || y >= cells.dims.y || z >= cells.dims.z) return;
    const std::size_t row = cells.offset({0, y, z});
    std::uint8_t* held = set.data() + row;
    from = std::max(from, 0);
    to = std::min(to, cells.dims.x);
    for (int x = from; x < to; ++x) {
      if (!held[x]) continue;
      int begin = x, end = x;
      while (begin > 0 && held[begin - 1]) --begin;
      for (; end < cells.dims.x && held[end]; ++end) held[end] = 0;
      std::fill(held + begin, held + x, std::uint8_t{0});
      for (int i = begin; i < end; ++i) part.push_back(static_cast<std::uint32_t>(row) + static_cast<std::uint32_t>(i));
      open.push_back({begin, end, y, z});
      x = end;
    }
  };
  for (auto first = set.begin();; ++first) {
    first = std::find_if(first, set.end(), [](std::uint8_t held) { return held != 0; });
    if (first == set.end()) return;
    part.clear();
    const glm::ivec3 seed = cells.at(static_cast<std::size_t>(first - set.begin()));
    addRow(seed.x, seed.x + 1, seed.y, seed.z);
    while (!open.empty()) {
      const Stretch next = open.back();
      open.pop_back();
      for (int n = 0; n < 9; ++n) addRow(next.begin - 1, next.end + 1, next.y + n % 3 - 1, next.z + n / 3 - 1);
    }
    take(std::as_const(part));
  }
}

/// Whether an opened part belongs to the body; `depth`: mm to the nearest cell that is not solid, or infinite beyond
/// that of a slab.
bool isOfBody(const Cells& cells, const std::vector<std::uint32_t>& part, const std::vector<float>& depth) {
  if (static_cast<double>(part.size()) * cells.cellVolume() < leastPart) return false;
  double sum = 0.0, deepest = 0.0;
  glm::ivec3 low = cells.dims, high(0);
  for (const std::uint32_t i : part) {
    sum += cells.mean[i];
    deepest = std::max(deepest, static_cast<double>(depth[i]));
    low = glm::min(low, cells.at(i));
    high = glm::max(high, cells.at(i));
  }
  const double mean = sum / static_cast<double>(part.size());
  const bool isSlab = deepest <= deepestSlab && glm::length(glm::dvec3(high - low + 1) * cells.spacing) > slabLength;
  return mean >= leastMean && mean <= greatestMean && !isSlab;
}

/// What is matter and not farther from the opened body than it was opened by.
Flags bodyOf(const Cells& cells) {
  std::vector<float> depth =
      distanceTo(cells, flagsWhere(cells, [&](std::size_t i) { return cells.mean[i] <= solidValue; }), deepestSlab);
  Flags cores = flagsWhere(cells, [&](std::size_t i) { return depth[i] > openingRadius; });
  Flags body(cells.count(), 0);
  forEachPart(cells, cores, [&](const std::vector<std::uint32_t>& part) {
    if (!isOfBody(cells, part, depth)) return;
    for (const std::uint32_t i : part) body[i] = 1;
  });
  depth = distanceTo(cells, body, openingRadius + regrowth);
  return flagsWhere(
      cells, [&](std::size_t i) { return depth[i] <= openingRadius + regrowth && cells.greatest[i] > matterValue; });
}

/// The cells that the air around the body reaches in their axial plane, the planes across `axis`: from the volume's
/// faces through air and matter outside of the body. It does not pass tissue of the lung, which a scan may cut open.
Flags exteriorOf(const Cells& cells, const Flags& body, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const std::array<std::size_t, 3> steps{
      1, static_cast<std::size_t>(cells.dims.x),
      static_cast<std::size_t>(cells.dims.x) * static_cast<std::size_t>(cells.dims.y)};
  const std::size_t along = steps[static_cast<std::size_t>(u)], across = steps[static_cast<std::size_t>(v)];
  Flags exterior(body.size(), 0);
  parallelFor(static_cast<std::size_t>(cells.dims[axis]), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<glm::ivec2> open;  // a cell of a stretch along u that the air reaches
    for (std::size_t plane = begin; plane < end; ++plane) {
      const auto offset = [&](int a, int b) {
        return plane * steps[static_cast<std::size_t>(axis)] + static_cast<std::size_t>(a) * along +
               static_cast<std::size_t>(b) * across;
      };
      const auto isAir = [&](std::size_t at) { return !body[at] && cells.mean[at] <= airyValue; };
      const auto lets = [&](std::size_t at) {
        return !exterior[at] && (isAir(at) || (!body[at] && cells.greatest[at] > matterValue));
      };
      const auto seed = [&](int a, int b) {
        if (isAir(offset(a, b))) open.emplace_back(a, b);
      };
      for (int a = 0; a < cells.dims[u]; ++a)
        for (const int b : {0, cells.dims[v] - 1}) seed(a, b);
      for (int b = 0; b < cells.dims[v]; ++b)
        for (const int a : {0, cells.dims[u] - 1}) seed(a, b);
      while (!open.empty()) {
        const glm::ivec2 cell = open.back();
        open.pop_back();
        if (!lets(offset(cell.x, cell.y))) continue;
        int first = cell.x, last = cell.x;
        while (first > 0 && lets(offset(first - 1, cell.y))) --first;
        while (last + 1 < cells.dims[u] && lets(offset(last + 1, cell.y))) ++last;
        for (int a = first; a <= last; ++a) exterior[offset(a, cell.y)] = 1;
        for (const int b : {cell.y - 1, cell.y + 1}) {
          if (b < 0 || b >= cells.dims[v]) continue;
          bool isBefore = false;
          for (int a = first; a <= last; ++a) {
            const bool is = lets(offset(a, b));
            if (is && !isBefore) open.emplace_back(a, b);
            isBefore = is;
          }
        }
      }
    }
  });
  return exterior;
}

int axialAxis(const Grid& grid) {
  int axis = 2;
  for (int other = 0; other < 2; ++other)
    if (std::abs(grid.direction[other].z) > std::abs(grid.direction[axis].z)) axis = other;
  return axis;
}

/// The parts outside the body that are none of its appendages.
Flags partsToHide(const Cells& cells, const Flags& body, const Flags& exterior) {
  const double touching = 1.01 * glm::length(cells.spacing);  // a cell that shares a corner
  const std::vector<float> away = distanceTo(cells, body, std::max(touching, appendageReach));
  Flags rest = flagsWhere(cells, [&](std::size_t i) { return !body[i] && cells.greatest[i] > matterValue; });
  Flags hidden(body.size(), 0);
  forEachPart(cells, rest, [&](const std::vector<std::uint32_t>& part) {
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0.0f;
    bool isOutside = false;
    for (const std::uint32_t i : part) {
      isOutside = isOutside || exterior[i];
      nearest = std::min(nearest, away[i]);
      farthest = std::max(farthest, away[i]);
    }
    if (!isOutside || (nearest <= touching && farthest <= appendageReach)) return;
    // Cells beside the body hold its skin, so they stay.
    for (const std::uint32_t i : part) hidden[i] = away[i] > touching;
  });
  return hidden;
}

/// Adds the cells beside hidden ones that are not kept.
void addShell(const Cells& cells, const Flags& kept, Flags& hidden) {
  std::vector<std::uint32_t> rim;
  for (std::size_t i = 0; i < hidden.size(); ++i)
    if (hidden[i]) rim.push_back(static_cast<std::uint32_t>(i));
  for (int step = 0; step < shellCells; ++step) {
    std::vector<std::uint32_t> added;
    for (const std::uint32_t i : rim)
      for (int n = 0; n < 27; ++n) {
        const glm::ivec3 beside = cells.at(i) + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
        if (!cells.contains(beside)) continue;
        const std::size_t at = cells.offset(beside);
        if (hidden[at] || kept[at]) continue;
        hidden[at] = 1;
        added.push_back(static_cast<std::uint32_t>(at));
      }
    rim = std::move(added);
  }
}

}  // namespace

CoarseMask findTable(const Volume& volume) {
  CoarseMask mask;
  if (!volume.isInHounsfieldUnits()) return mask;
  const Cells cells = cellsOf(volume);
  const Flags body = bodyOf(cells);
  if (std::find(body.begin(), body.end(), 1) == body.end()) return mask;
  const Flags exterior = exteriorOf(cells, body, axialAxis(volume.grid));
  Flags hidden = partsToHide(cells, body, exterior);
  // These stay: the body, and matter that is not hidden.
  const Flags kept =
      flagsWhere(cells, [&](std::size_t i) { return body[i] || (cells.greatest[i] > matterValue && !hidden[i]); });
  addShell(cells, kept, hidden);
  mask.stride = cells.stride;
  mask.dims = cells.dims;
  mask.count = static_cast<std::size_t>(std::count(hidden.begin(), hidden.end(), 1));
  mask.cells.assign(hidden.begin(), hidden.end());
  return mask;
}

std::shared_ptr<const CoarseMask> tableOf(const Volume& volume) {
  try {
    return std::make_shared<CoarseMask>(findTable(volume));
  } catch (const std::bad_alloc&) {
    return std::make_shared<CoarseMask>();
  }
}

}  // namespace fenestra::segmentation
