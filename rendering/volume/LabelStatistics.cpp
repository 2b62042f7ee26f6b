#include "rendering/volume/LabelStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Count, mean and sum of squared differences from it.
struct Moments {
  double count = 0.0, mean = 0.0, squares = 0.0;

  void merge(const Moments& other) {
    if (other.count == 0.0) return;
    const double all = count + other.count, difference = other.mean - mean;
    squares += other.squares + difference * difference * count * other.count / all;
    mean += difference * other.count / all;
    count = all;
  }
};

struct LabelSums {
  std::size_t voxels = 0;
  Moments values;
  double least = unbounded, greatest = -unbounded;
  glm::dvec3 indices{0.0};                      ///< sum of the voxels' indices
  glm::dvec3 low{unbounded}, high{-unbounded};  ///< of the voxels' centres, LPS mm

  void merge(const LabelSums& other) {
    voxels += other.voxels;
    values.merge(other.values);
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
    indices += other.indices;
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
};

/// Adds the values of a run of voxels.
template <class Scalar>
void addValues(LabelSums& sums, const Volume& volume, const Scalar* stored, int count) {
  Moments run;
  // Differences from a value of the run, so that squares of large values do not cancel.
  double origin = 0.0, sum = 0.0, squares = 0.0;
  for (int i = 0; i < count; ++i) {
    const double value = volume.slope * static_cast<double>(stored[i]) + volume.intercept;
    if (!std::isfinite(value)) continue;
    if (run.count == 0.0) origin = value;
    run.count += 1.0;
    sum += value - origin;
    squares += (value - origin) * (value - origin);
    sums.least = std::min(sums.least, value);
    sums.greatest = std::max(sums.greatest, value);
  }
  if (run.count == 0.0) return;
  run.mean = origin + sum / run.count;
  run.squares = std::max(squares - sum * sum / run.count, 0.0);
  sums.values.merge(run);
}

/// Adds the places of the voxels from `first` to `last` of a row.
void addPlaces(LabelSums& sums, const glm::dmat4& worldFromIndex, glm::ivec3 first, int last) {
  const int count = last - first.x + 1;
  sums.voxels += static_cast<std::size_t>(count);
  sums.indices += static_cast<double>(count) * glm::dvec3(0.5 * (first.x + last), first.y, first.z);
  for (const int x : {first.x, last}) {
    const glm::dvec3 world(worldFromIndex * glm::dvec4(x, first.y, first.z, 1.0));
    sums.low = glm::min(sums.low, world);
    sums.high = glm::max(sums.high, world);
  }
}

template <class Scalar>
void addRow(std::vector<LabelSums>& sums, const Volume& volume, const glm::dmat4& worldFromIndex,
            const std::vector<std::uint16_t>& labels, const Scalar* stored, glm::ivec3 row) {
  const auto width = static_cast<int>(labels.size());
  const auto at = [&](int x) { return labels[static_cast<std::size_t>(x)]; };
  for (int begin = 0; begin < width;) {
    int end = begin + 1;
    while (end < width && at(end) == at(begin)) ++end;
    if (const std::size_t label = at(begin); label != 0 && label < sums.size()) {
      addValues(sums[label], volume, stored + begin, end - begin);
      addPlaces(sums[label], worldFromIndex, {begin, row.y, row.z}, end - 1);
    }
    begin = end;
  }
}

LabelStatistics statisticsOf(const LabelSums& sums, std::uint16_t label, const Grid& grid) {
  LabelStatistics result;
  result.label = label;
  result.voxels = sums.voxels;
  if (sums.voxels == 0) return result;
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dmat3 steps(worldFromIndex);
  result.millilitres = static_cast<double>(sums.voxels) * std::abs(glm::determinant(steps)) / 1000.0;
  result.valued = static_cast<std::size_t>(sums.values.count);
  if (result.valued > 0) {
    result.mean = sums.values.mean;
    if (result.valued > 1) result.deviation = std::sqrt(sums.values.squares / (sums.values.count - 1.0));
    result.least = sums.least;
    result.greatest = sums.greatest;
  }
  const glm::dvec3 half = 0.5 * (glm::abs(steps[0]) + glm::abs(steps[1]) + glm::abs(steps[2]));
  result.low = sums.low - half;
  result.high = sums.high + half;
  const glm::dvec3 index = sums.indices / static_cast<double>(sums.voxels);
  result.centre = glm::dvec3(worldFromIndex * glm::dvec4(index, 1.0));
  return result;
}

/// A label's voxel that is nearest to its centre so far.
struct NearestVoxel {
  double distance = unbounded;  ///< squared, mm²
  glm::dvec3 place{0.0};        ///< world, mm

  void offer(glm::dvec3 at, glm::dvec3 centre) {
    const glm::dvec3 away = at - centre;
    if (const double squared = glm::dot(away, away); squared < distance) *this = {squared, at};
  }
};

/// Looks at the runs of one label in a row: the nearest of a run lies where the centre is projected onto the row.
void offerRow(std::vector<NearestVoxel>& nearest, const std::vector<std::uint16_t>& labels,
              const std::vector<glm::dvec3>& centres, const glm::dmat4& worldFromIndex, glm::ivec3 row) {
  const glm::dvec3 start(worldFromIndex * glm::dvec4(row, 1.0)), along(worldFromIndex[0]);
  for (std::size_t begin = 0, end = 0; begin < labels.size(); begin = end) {
    while (end < labels.size() && labels[end] == labels[begin]) ++end;
    const std::size_t label = labels[begin];
    if (label == 0 || label >= centres.size()) continue;
    const double x = glm::dot(centres[label] - start, along) / glm::dot(along, along);
    const double held = std::clamp(std::round(x), static_cast<double>(begin), static_cast<double>(end - 1));
    nearest[label].offer(start + held * along, centres[label]);
  }
}

}  // namespace

std::vector<LabelStatistics> labelStatistics(const LabelMap& labels, const Volume& volume) {
  std::size_t listed = 1;
  for (const Label& label : labels.labels) listed = std::max<std::size_t>(listed, std::size_t{label.value} + 1);
  const Grid& grid = labels.grid;
  const auto width = static_cast<std::size_t>(grid.dims.x);
  const std::size_t rows = static_cast<std::size_t>(grid.dims.y) * static_cast<std::size_t>(grid.dims.z);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();

  // By its first row: pieces end in any order, and the order of a sum changes its last digits.
  std::map<std::size_t, std::vector<LabelSums>> pieces;
  std::mutex mutex;
  constexpr std::size_t worthAThread = 1 << 18;
  parallelFor(rows, worthAThread / std::max<std::size_t>(width, 1) + 1, [&](std::size_t begin, std::size_t end) {
    std::vector<LabelSums> sums(listed);
    std::vector<std::uint16_t> ofRow(width);
    volume.voxels.visit([&](auto scalars) {
      for (std::size_t row = begin; row < end; ++row) {
        if (row % 64 == 0) interruptionPoint();
        labels.voxels.visit([&](auto values) {
          for (std::size_t x = 0; x < width; ++x) ofRow[x] = static_cast<std::uint16_t>(values[row * width + x]);
        });
        const auto y = static_cast<int>(row % static_cast<std::size_t>(grid.dims.y));
        const auto z = static_cast<int>(row / static_cast<std::size_t>(grid.dims.y));
        addRow(sums, volume, worldFromIndex, ofRow, scalars.data() + row * width, {0, y, z});
      }
    });
    const std::lock_guard lock(mutex);
    pieces.emplace(begin, std::move(sums));
  });
  std::vector<LabelSums> all(listed);
  for (const auto& [begin, sums] : pieces)
    for (std::size_t value = 0; value < listed; ++value) all[value].merge(sums[value]);

  std::vector<LabelStatistics> result;
  for (const Label& label : labels.labels) result.push_back(statisticsOf(all[label.value], label.value, grid));
  return result;
}

std::vector<glm::dvec3> placesWithin(const LabelMap& labels, const std::vector<LabelStatistics>& statistics) {
  std::size_t listed = 1;
  for (const LabelStatistics& each : statistics) listed = std::max<std::size_t>(listed, std::size_t{each.label} + 1);
  std::vector<glm::dvec3> centres(listed, glm::dvec3(0.0));
  for (const LabelStatistics& each : statistics) centres[each.label] = each.centre;
  const Grid& grid = labels.grid;
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const auto width = static_cast<std::size_t>(grid.dims.x), height = static_cast<std::size_t>(grid.dims.y);
  const std::size_t rows = height * static_cast<std::size_t>(grid.dims.z);

  std::map<std::size_t, std::vector<NearestVoxel>> pieces;  // by the first row, so that ties end alike
  std::mutex mutex;
  constexpr std::size_t worthAThread = 1 << 18;
  parallelFor(rows, worthAThread / std::max<std::size_t>(width, 1) + 1, [&](std::size_t begin, std::size_t end) {
    std::vector<NearestVoxel> nearest(listed);
    std::vector<std::uint16_t> ofRow(width);
    for (std::size_t row = begin; row < end; ++row) {
      if (row % 64 == 0) interruptionPoint();
      labels.voxels.visit([&](auto values) {
        for (std::size_t x = 0; x < width; ++x) ofRow[x] = static_cast<std::uint16_t>(values[row * width + x]);
      });
      offerRow(nearest, ofRow, centres, worldFromIndex,
               {0, static_cast<int>(row % height), static_cast<int>(row / height)});
    }
    const std::lock_guard lock(mutex);
    pieces.emplace(begin, std::move(nearest));
  });
  std::vector<NearestVoxel> all(listed);
  for (const auto& [begin, nearest] : pieces)
    for (std::size_t value = 0; value < listed; ++value)
      if (nearest[value].distance < all[value].distance) all[value] = nearest[value];

  std::vector<glm::dvec3> places;
  for (const LabelStatistics& each : statistics) places.push_back(all[each.label].place);
  return places;
}

}  // namespace fenestra
