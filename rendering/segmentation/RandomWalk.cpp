#include "rendering/segmentation/RandomWalk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

// Chosen on the marked nuclei of tests/bench/results/growing.md.
constexpr double seedBall = 2.0;       ///< mm
constexpr double sphereRadius = 32.0;  ///< mm
constexpr double cellSide = 1.0;       ///< mm: finer voxels are taken together
/// The least deviation, as a share of the noise's unit: a scan with less noise has no smaller differences.
constexpr double leastNoise = 0.25;
/// Deviations of the noise: a step is as likely as the inverse square of the difference, where that is more.
constexpr double leastStep = 0.05;
constexpr double residualShare = 3e-3;  ///< a third of it makes no better regions
constexpr int mostIterations = 400;
constexpr double walkLevelsPerOctave = 16.0;  ///< of the probability
constexpr double walkRoundness = 0.9;         ///< how much a compact shape counts against a sharp border
constexpr float acrossFaces = 0.7f;           ///< of a difference over three faces, as that of a blurred edge

/// The cells of the sphere's box.
struct WalkCells {
  glm::ivec3 size{1};  ///< voxels of a cell
  VoxelBox box, cells;
  std::vector<float> tones;  ///< by cell, deviations of the noise

  glm::ivec3 cellOf(glm::ivec3 voxel) const { return (voxel - box.low) / size; }
  double awayOf(glm::ivec3 cell, glm::ivec3 voxel, const Grid& grid) const {
    const glm::dvec3 middle = glm::dvec3(box.low + cell * size) + 0.5 * glm::dvec3(size - 1);
    return glm::length(glm::dvec3(grid.worldFromIndex() * glm::dvec4(middle - glm::dvec3(voxel), 0.0)));
  }
  /// From a cell to the next one along each axis, in `tones`.
  std::array<std::size_t, 3> steps() const {
    const auto row = static_cast<std::size_t>(cells.dims().x);
    return {1, row, row * static_cast<std::size_t>(cells.dims().y)};
  }
};

double walkUnit(const Noise& noise) { return std::max(noise.deviation, leastNoise * noise.unit); }

WalkCells walkCells(const Volume& volume, const Noise& noise, glm::ivec3 seed) {
  WalkCells result;
  glm::ivec3 half;
  for (int axis = 0; axis < 3; ++axis) {
    int& size = result.size[axis];
    size = std::max(1, static_cast<int>(std::round(cellSide / volume.grid.spacing[axis])));
    half[axis] = (static_cast<int>(std::ceil(sphereRadius / (volume.grid.spacing[axis] * size))) + 1) * size;
  }
  result.box = VoxelBox{seed - half, seed + half + 1}.clippedTo(wholeOf(volume.grid.dims));
  result.cells = wholeOf((result.box.dims() + result.size - 1) / result.size);
  result.tones.resize(result.cells.count());
  const ToneScale scale(volume, noise, softTissue);
  const auto perUnit = static_cast<float>(noise.unit / walkUnit(noise));
  const std::size_t slice = result.steps()[2];
  parallelFor(static_cast<std::size_t>(result.cells.dims().z), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<float> sums(slice), counts(slice);
    for (std::size_t z = begin; z < end; ++z) {
      VoxelBox slab = result.box;
      slab.low.z += static_cast<int>(z) * result.size.z;
      slab.high.z = std::min(slab.low.z + result.size.z, slab.high.z);
      const std::vector<float> values = smoothedTones(volume, slab, scale);
      std::ranges::fill(sums, 0.0f);
      std::ranges::fill(counts, 0.0f);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const glm::ivec3 at = (slab.at(i) - slab.low) / result.size;
        const auto cell = static_cast<std::size_t>(at.x + result.cells.dims().x * at.y);
        sums[cell] += values[i];
        ++counts[cell];
      }
      for (std::size_t cell = 0; cell < slice; ++cell)
        result.tones[z * slice + cell] = perUnit * sums[cell] / counts[cell];
    }
  });
  return result;
}

/// Solves for the probability of each cell: the mean of its neighbours' by how likely steps to them are.
class WalkSolver {
 public:
  WalkSolver(const WalkCells& cells, const Grid& grid, std::span<const glm::ivec3> inside,
             std::span<const glm::ivec3> outside)
      : steps_(cells.steps()), slices_(static_cast<std::size_t>(cells.cells.dims().z)) {
    const std::size_t count = cells.cells.count();
    solution_.assign(count, 0.0f);
    diagonal_.assign(count, 0.0f);
    perDiagonal_.assign(count, 0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double side = grid.spacing[static_cast<int>(axis)] * cells.size[static_cast<int>(axis)];
      const auto scale = static_cast<float>(1.0 / (side * side));
      weights_[axis].assign(count, 0.0f);
      for (std::size_t i = 0; i < count; ++i) {
        if (cells.cells.at(i)[static_cast<int>(axis)] + 1 == cells.cells.dims()[static_cast<int>(axis)]) continue;
        const float difference = cells.tones[i + steps_[axis]] - cells.tones[i];
        weights_[axis][i] = scale / (difference * difference + static_cast<float>(leastStep * leastStep));
        diagonal_[i] += weights_[axis][i];
        diagonal_[i + steps_[axis]] += weights_[axis][i];
      }
    }
    setEnds(cells, grid, inside, outside);
  }

  /// By conjugate gradients with the diagonal as preconditioner.
  std::vector<float> run() {
    std::vector<float> residual(solution_.size(), 0.0f), way = residual, image = residual;
    double size = sumOf([&](std::size_t i) {
      residual[i] = -imageAt(solution_, i);
      way[i] = residual[i] * perDiagonal_[i];
      return residual[i] * way[i];
    });
    const double wanted = residualShare * residualShare * size;
    for (int iteration = 0; iteration < mostIterations && size > wanted; ++iteration) {
      interruptionPoint();
      const double curvature = sumOf([&](std::size_t i) { return (image[i] = imageAt(way, i)) * way[i]; });
      const auto length = static_cast<float>(size / curvature);
      const double next = sumOf([&](std::size_t i) {
        solution_[i] += length * way[i];
        residual[i] -= length * image[i];
        return residual[i] * residual[i] * perDiagonal_[i];
      });
      const auto share = static_cast<float>(next / size);
      sumOf([&](std::size_t i) {
        way[i] = residual[i] * perDiagonal_[i] + share * way[i];
        return 0.0f;
      });
      size = next;
    }
    return std::move(solution_);
  }

 private:
  /// What is no end is free.
  void setEnds(const WalkCells& cells, const Grid& grid, std::span<const glm::ivec3> inside,
               std::span<const glm::ivec3> outside) {
    free_.resize(slices_);
    const auto isAt = [&](glm::ivec3 cell, glm::ivec3 seed) {
      return cells.box.contains(seed) && (cells.cellOf(seed) == cell || cells.awayOf(cell, seed, grid) <= seedBall);
    };
    for (std::size_t i = 0; i < solution_.size(); ++i) {
      const glm::ivec3 cell = cells.cells.at(i);
      if (std::ranges::any_of(inside, [&](glm::ivec3 seed) { return isAt(cell, seed); })) {
        solution_[i] = 1.0f;
      } else if (diagonal_[i] > 0.0f && cells.awayOf(cell, inside.front(), grid) < sphereRadius &&
                 std::ranges::none_of(outside, [&](glm::ivec3 seed) { return isAt(cell, seed); })) {
        free_[i / steps_[2]].push_back(static_cast<std::uint32_t>(i));
        perDiagonal_[i] = 1.0f / diagonal_[i];
      }
    }
  }

  /// A free cell's row of the equations. Steps beyond the box have no weight.
  float imageAt(const std::vector<float>& of, std::size_t i) const {
    float sum = diagonal_[i] * of[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (i + steps_[axis] < of.size()) sum -= weights_[axis][i] * of[i + steps_[axis]];
      if (i >= steps_[axis]) sum -= weights_[axis][i - steps_[axis]] * of[i - steps_[axis]];
    }
    return sum;
  }

  /// Over the free cells, slice by slice: the sum does not depend on the number of cores.
  template <class Term>
  double sumOf(Term term) {
    std::vector<double> sums(slices_, 0.0);
    parallelFor(slices_, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t z = begin; z < end; ++z) {
        double sum = 0.0;
        for (const std::uint32_t i : free_[z]) sum += static_cast<double>(term(i));
        sums[z] = sum;
      }
    });
    double sum = 0.0;
    for (const double each : sums) sum += each;
    return sum;
  }

  std::array<std::size_t, 3> steps_;
  std::size_t slices_;
  std::array<std::vector<float>, 3> weights_;             ///< from a cell to the next one along each axis
  std::vector<float> diagonal_, perDiagonal_, solution_;  ///< sums of weights; one by them, where free
  std::vector<std::vector<std::uint32_t>> free_;          ///< by slice
};

Level walkLevel(float probability) {
  if (!(probability > 0.0f)) return never;
  const double level = std::floor(-walkLevelsPerOctave * std::log2(std::min(1.0, static_cast<double>(probability))));
  return level < levelCount ? static_cast<Level>(level) : never;
}

/// Sums over each level set, by level: mm³, mm², and mm² times deviations of the noise.
struct WalkSums {
  std::array<double, 256> volume{}, area{}, difference{}, seen{};

  void addFace(Level a, Level b, double faceArea, double across, bool isSeen) {
    for (const auto& [level, sign] : {std::pair{std::min(a, b), 1.0}, {std::max(a, b), -1.0}}) {
      area[level] += sign * faceArea;
      difference[level] += sign * faceArea * across;
      if (isSeen) seen[level] += sign * faceArea;
    }
  }
  void accumulate() {
    for (auto* sums : {&volume, &area, &difference, &seen})
      for (std::size_t level = 1; level < sums->size(); ++level) (*sums)[level] += (*sums)[level - 1];
  }
  double compactness(std::size_t level) const {
    return std::cbrt(36.0 * std::numbers::pi * volume[level] * volume[level]) / area[level];
  }
};

WalkSums walkSums(const WalkCells& cells, const std::vector<Level>& levels, const Grid& grid) {
  WalkSums sums;
  const std::array<std::size_t, 3> steps = cells.steps();
  const double volume = grid.voxelVolume() * cells.size.x * cells.size.y * cells.size.z;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    sums.volume[levels[i]] += volume;
    for (int axis = 0; axis < 3; ++axis) {
      const int at = cells.cells.at(i)[axis], last = cells.cells.dims()[axis] - 1;
      const std::size_t step = steps[static_cast<std::size_t>(axis)];
      if (at == last || levels[i] == levels[i + step]) continue;
      const float across = std::abs(cells.tones[i + step] - cells.tones[i]);
      const float wide =
          at > 0 && at + 1 < last ? acrossFaces * std::abs(cells.tones[i + 2 * step] - cells.tones[i - step]) : 0.0f;
      sums.addFace(levels[i], levels[i + step], volume / (grid.spacing[axis] * cells.size[axis]),
                   static_cast<double>(across), std::max(across, wide) >= 1.0f);
    }
  }
  sums.accumulate();
  return sums;
}

/// The level of the clearest set; empty where none is clearer than those beside it.
std::optional<std::size_t> clearestSet(const WalkSums& sums, const WalkBounds& bounds) {
  const auto clarity = [&](std::size_t level) {
    return sums.area[level] > 0.0 && sums.difference[level] > 0.0
               ? std::log(sums.difference[level] / sums.area[level]) +
                     walkRoundness * std::log(std::min(1.0, sums.compactness(level)))
               : -std::numeric_limits<double>::infinity();
  };
  std::optional<std::size_t> clearest;
  for (std::size_t level = 1; level + 1 < levelCount; ++level) {
    const double own = clarity(level);
    if (!std::isfinite(own) || sums.volume[level] < bounds.least || sums.volume[level] > bounds.most ||
        own < clarity(level - 1) || own < clarity(level + 1))
      continue;
    if (!clearest || own > clarity(*clearest)) clearest = level;
  }
  return clearest;
}

}  // namespace

std::optional<WalkRegion> walkRegion(const Volume& volume, const Noise& noise, std::span<const glm::ivec3> inside,
                                     std::span<const glm::ivec3> outside, const WalkBounds& bounds) {
  const WalkCells cells = walkCells(volume, noise, inside.front());
  const std::vector<float> probability = WalkSolver(cells, volume.grid, inside, outside).run();
  std::vector<Level> levels(probability.size());
  std::ranges::transform(probability, levels.begin(), walkLevel);
  const WalkSums sums = walkSums(cells, levels, volume.grid);
  const std::optional<std::size_t> clearest = clearestSet(sums, bounds);
  if (!clearest) return std::nullopt;
  WalkRegion region;
  region.box = cells.box;
  region.step = static_cast<int>(*clearest) + 1;
  region.contrast = sums.difference[*clearest] / sums.area[*clearest] * walkUnit(noise) / noise.unit;
  region.compactness = sums.compactness(*clearest);
  region.support = sums.seen[*clearest] / sums.area[*clearest];
  region.joins.resize(cells.box.count());
  for (std::size_t i = 0; i < region.joins.size(); ++i)
    region.joins[i] = levels[cells.cells.offset(cells.cellOf(cells.box.at(i)))];
  return region;
}

}  // namespace fenestra::segmentation
