#include "rendering/segmentation/Curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <mutex>
#include <numbers>

#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr double mostBetweenTissues = 80.0;  ///< HU: 48 costs a bladder 0.08 of its Dice

// Conditions for a plateau, chosen on the marked structures of tests/bench/results/growing.md. Half the contrast or
// twice the steadiness changes the mean Dice of the first setting by 0.01 there; twice the contrast or twice the fall
// costs 0.1 and more.
constexpr double noiseContrast = 1.6;     ///< noise deviations: surfaces with less lie in the noise
constexpr double leastContrast = 0.4;     ///< units of the noise: surfaces with less are not seen
constexpr double leastFall = 0.7;         ///< of the clarity, before a clearer surface follows
constexpr double leastVoxels = 50.0;      ///< fewer have no surface to speak of
constexpr double roundness = 1.5;         ///< how much a compact shape counts against a sharp edge
constexpr double steadiness = 0.5;        ///< how much it counts that the region has hardly grown of late
constexpr double largestGrowth = 3.0;     ///< of the volume's logarithm: more is no worse
constexpr double plateauShare = 0.1;      ///< volumes within this share of the best one's are the same plateau
constexpr double leastStructure = 500.0;  ///< mm³, a ball of a centimetre: specks are smaller

// Weights of the clarity in clearestStep(). The first five were chosen by coordinate search over the mean Dice, 0.3
// less for each region of more than twice the structure's size, on the structures marked in growing.md; the others by
// trial on some of them.
constexpr double sharpnessWeight = 0.7;
constexpr double compactnessWeight = 0.9;
constexpr double stayWeight = 0.5;       ///< for each octave of tolerance
constexpr double sizeWeight = 1.8;       ///< below the usual size
constexpr double usualStructure = 2e-4;  ///< of the body's volume
constexpr double longestStay = 2.0;      ///< octaves: more is no better
constexpr double mostForSize = 1.0;      ///< what a small size costs at most, so that a sharp lesion still is one
constexpr double excessWeight = 0.5;     ///< beyond the expected size, and beyond a large one
constexpr double oversizeCost = 3.0;     ///< beyond the greatest size: more than sharpness and stay can bring
constexpr double mostStructure = 0.15, mostGas = 0.6;  ///< of the body's volume
/// Share of the greatest size beyond which a region is more often a leak. In loud noise its border with air and bone is
/// clearer than that of an organ with its neighbours.
constexpr double muchShare = 1.0 / 3.0;

/// Steps over which growth is looked at: half an octave of tolerance.
constexpr auto lately = static_cast<std::size_t>(levelsPerOctave / 2.0);

/// Sums by the level from which they count; accumulated over levels they are sums by step.
struct Sums {
  std::array<double, 257> voxels{}, area{}, rise{};

  void add(const Sums& other) {
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      voxels[i] += other.voxels[i];
      area[i] += other.area[i];
      rise[i] += other.rise[i];
    }
  }
};

class Counter {
 public:
  Counter(std::span<const Level> joins, std::span<const Level> costs, const Grid& grid, glm::ivec3 dims,
          double mostRise)
      : joins_(joins), costs_(costs), dims_(dims), mostRise_(mostRise) {
    for (int level = 0; level < levelCount; ++level) cost_[static_cast<std::size_t>(level)] = costOf(level);
    cost_[never] = costOf(levelCount);
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 a = grid.direction[(axis + 1) % 3] * grid.spacing[(axis + 1) % 3];
      const glm::dvec3 b = grid.direction[(axis + 2) % 3] * grid.spacing[(axis + 2) % 3];
      faceArea_[axis] = glm::length(glm::cross(a, b));
    }
  }

  void count(int z, Sums& sums) const {
    const std::array<std::size_t, 3> steps{1, static_cast<std::size_t>(dims_.x),
                                           static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y)};
    std::size_t at = wholeOf(dims_).offset({0, 0, z});
    for (int y = 0; y < dims_.y; ++y)
      for (int x = 0; x < dims_.x; ++x, ++at) {
        const glm::bvec3 last(x + 1 == dims_.x, y + 1 == dims_.y, z + 1 == dims_.z);
        if (const int alike = countAlike(at, x, last, steps); alike > 0) {
          if (joins_[at] != never) sums.voxels[joins_[at]] += alike;
          x += alike - 1;
          at += static_cast<std::size_t>(alike) - 1;
          continue;
        }
        if (joins_[at] != never) ++sums.voxels[joins_[at]];
        for (int axis = 0; axis < 3; ++axis)
          if (!last[axis] && joins_[at] != joins_[at + steps[static_cast<std::size_t>(axis)]])
            face(at, at + steps[static_cast<std::size_t>(axis)], faceArea_[axis], sums);
      }
  }

 private:
  /// Eight where that many voxels from one on join with it, and with all their next ones; otherwise none.
  int countAlike(std::size_t at, int x, glm::bvec3 last, const std::array<std::size_t, 3>& steps) const {
    constexpr int many = sizeof(std::uint64_t);
    if (x + many >= dims_.x) return 0;
    const auto some = [&](std::size_t from) {
      std::uint64_t levels;
      std::memcpy(&levels, joins_.data() + from, sizeof levels);
      return levels;
    };
    const std::uint64_t own = some(at);
    const bool alike =
        own == some(at + 1) && (last.y || own == some(at + steps[1])) && (last.z || own == some(at + steps[2]));
    return alike ? many : 0;
  }

  /// The face between two voxels is part of the surface from the level of the one until the other joins.
  void face(std::size_t a, std::size_t b, double area, Sums& sums) const {
    if (joins_[a] > joins_[b]) std::swap(a, b);
    const double rise = area * std::clamp(cost_[costs_[b]] - cost_[costs_[a]], -mostRise_, mostRise_);
    sums.area[joins_[a]] += area;
    sums.area[joins_[b]] -= area;
    sums.rise[joins_[a]] += rise;
    sums.rise[joins_[b]] -= rise;
  }

  std::span<const Level> joins_, costs_;
  glm::ivec3 dims_;
  double mostRise_;
  std::array<double, 256> cost_{};
  glm::dvec3 faceArea_{0.0};
};

/// How far the region has grown over the steps before, as the volume's logarithm.
double growthBefore(const GrowthCurve& curve, std::size_t step) {
  const double before = curve.volume[step - std::min(step, lately)];
  return before > 0.0 ? std::min(largestGrowth, std::log(curve.volume[step] / before)) : largestGrowth;
}

/// How clearly the region at each step is one structure: its surface is sharp and compact (leaks are ragged), and it
/// stays as it is while the tolerance rises. A logarithm; -inf where there is no region or no surface.
std::vector<double> clarityOf(const GrowthCurve& curve, double voxelVolume) {
  std::vector<double> clarity(curve.volume.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t step = 0; step < clarity.size(); ++step)
    if (curve.volume[step] >= leastVoxels * voxelVolume && curve.contrast[step] > 0.0)
      // Faces on the border of the volume do not count, so that a region that fills the volume would be more compact
      // than a ball.
      clarity[step] = std::log(curve.contrast[step]) + roundness * std::log(std::min(1.0, curve.compactness[step])) -
                      steadiness * growthBefore(curve, step);
  return clarity;
}

/// How far the clarity falls after a step before it is exceeded; infinite when nothing clearer follows.
double fallAfter(const std::vector<double>& clarity, std::size_t step) {
  double least = clarity[step];
  for (std::size_t later = step + 1; later < clarity.size(); ++later) {
    if (clarity[later] > clarity[step]) return clarity[step] - least;
    least = std::min(least, clarity[later]);
  }
  return std::numeric_limits<double>::infinity();
}

Plateau plateauAround(std::size_t best, const GrowthCurve& curve) {
  const double volume = curve.volume[best];
  std::size_t first = best, last = best;
  while (first > 1 && curve.volume[first - 1] >= (1.0 - plateauShare) * volume) --first;
  while (last + 1 < curve.volume.size() && curve.volume[last + 1] <= (1.0 + plateauShare) * volume) ++last;
  return {static_cast<int>(first), static_cast<int>(last), static_cast<int>(best), volume, curve.contrast[best]};
}

/// Where to begin: at the first plateau, or at the next one where that is a speck and the next one is neither a speck
/// nor more than half of all. Bright bone is no even tissue: a click on it meets a clear grain before it meets the
/// bone.
const Plateau& firstOf(const std::vector<Plateau>& plateaus, double allVolume) {
  const auto isStructure = [&](const Plateau& each) {
    return each.volume >= leastStructure && each.volume <= 0.5 * allVolume;
  };
  const auto structure = std::find_if(plateaus.begin(), plateaus.end(), isStructure);
  return plateaus.front().volume < leastStructure && structure != plateaus.end() ? *structure : plateaus.front();
}

/// Local maxima of the clarity on a contrast, before a fall; where to begin is one of them.
void findPlateaus(GrowthCurve& curve, double voxelVolume, double noiseShare, double allVolume) {
  const std::vector<double> clarity = clarityOf(curve, voxelVolume);
  const double contrast = std::max(leastContrast, noiseContrast * noiseShare);
  for (std::size_t step = 1; step < clarity.size(); ++step) {
    const bool peak = std::isfinite(clarity[step]) && clarity[step] > clarity[step - 1] &&
                      (step + 1 == clarity.size() || clarity[step] >= clarity[step + 1]);
    if (peak && curve.contrast[step] >= contrast && fallAfter(clarity, step) >= leastFall)
      curve.plateaus.push_back(plateauAround(step, curve));
  }
  if (!curve.plateaus.empty()) {
    curve.automatic = firstOf(curve.plateaus, allVolume).best;
    return;
  }
  // Nothing stands out: take the clearest surface, or where the regions are too small for one, the least tolerance that
  // has voxels.
  const auto clearest = std::max_element(clarity.begin(), clarity.end());
  const auto any = std::find_if(curve.volume.begin(), curve.volume.end(), [](double volume) { return volume > 0.0; });
  curve.automatic = std::isfinite(*clearest)    ? static_cast<int>(clearest - clarity.begin())
                    : any != curve.volume.end() ? static_cast<int>(any - curve.volume.begin())
                                                : 0;
}

constexpr double noClarity = -std::numeric_limits<double>::infinity();

/// By step: how clearly its region is one structure; noClarity where it is none.
std::vector<double> structureClarity(const GrowthCurve& curve, const StructurePrior& prior, const Grid& grid) {
  std::vector<double> clarities(curve.volume.size(), noClarity);
  const double least = leastVoxels * grid.voxelVolume();
  std::size_t changes = curve.volume.size();  // the next step with another region
  for (std::size_t step = curve.volume.size(); step-- > 1;) {
    const double volume = curve.volume[step];
    if (step + 1 < curve.volume.size() && curve.volume[step + 1] != volume) changes = step + 1;
    if (volume < least || volume > prior.limit || curve.contrast[step] <= prior.contrast) continue;
    const double octaves = std::min(longestStay, static_cast<double>(changes - step) / levelsPerOctave);
    clarities[step] = sharpnessWeight * std::log(curve.contrast[step]) +
                      compactnessWeight * std::log(std::min(1.0, curve.compactness[step])) + stayWeight * octaves +
                      std::max(-mostForSize, sizeWeight * std::min(0.0, std::log(volume / prior.usual))) -
                      excessWeight * std::max(0.0, std::log(volume / prior.expected)) - costOfMuch(volume, prior) -
                      (volume > prior.most ? oversizeCost : 0.0);
  }
  return clarities;
}

}  // namespace

EdgeScale competingEdges(const Volume& volume, const Noise& noise) {
  EdgeScale edges{noise.share()};
  if (volume.isInHounsfieldUnits()) edges.mostRise = std::min(edges.mostRise, mostBetweenTissues / noise.unit);
  return edges;
}

GrowthCurve growthCurve(std::span<const Level> joins, std::span<const Level> costs, const Grid& grid, glm::ivec3 dims,
                        const EdgeScale& edges) {
  const Counter counter(joins, costs, grid, dims, edges.mostRise);
  Sums sums;
  std::mutex mutex;
  parallelFor(static_cast<std::size_t>(dims.z), 4, [&](std::size_t begin, std::size_t end) {
    Sums local;
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z) counter.count(z, local);
    const std::scoped_lock lock(mutex);
    sums.add(local);
  });
  GrowthCurve curve;
  curve.mostRise = edges.mostRise;
  double voxels = 0.0, area = 0.0, rise = 0.0;
  for (int step = 0; step <= stepCount; ++step) {
    if (step > 0) {
      const auto level = static_cast<std::size_t>(step - 1);
      voxels += sums.voxels[level];
      area += sums.area[level];
      rise += sums.rise[level];
    }
    const double volume = voxels * grid.voxelVolume();
    curve.volume.push_back(volume);
    curve.contrast.push_back(area > 0.0 ? rise / area : 0.0);
    curve.compactness.push_back(area > 0.0 ? std::cbrt(36.0 * std::numbers::pi * volume * volume) / area : 0.0);
  }
  findPlateaus(curve, grid.voxelVolume(), edges.noise, static_cast<double>(wholeOf(dims).count()) * grid.voxelVolume());
  return curve;
}

StructurePrior structurePrior(double body, bool isGas) {
  const double most = (isGas ? mostGas : mostStructure) * body;
  return {.usual = usualStructure * body, .most = most, .much = muchShare * most, .limit = mostGas * body};
}

double costOfMuch(double volume, const StructurePrior& prior) {
  return volume > prior.most ? 0.0 : excessWeight * std::max(0.0, std::log(volume / prior.much));
}

std::optional<ClearestStep> clearestStep(const GrowthCurve& curve, const StructurePrior& prior, const Grid& grid,
                                         int last) {
  std::optional<ClearestStep> clearest;
  double chosen = 0.0;  // the clarity at clearest->step
  const std::vector<double> clarities = structureClarity(curve, prior, grid);
  for (std::size_t step = curve.volume.size(); step-- > 1;) {
    const double clarity = clarities[step];
    if (static_cast<int>(step) > last || clarity == noClarity) continue;
    const bool isSmaller = clearest && curve.volume[step] < curve.volume[static_cast<std::size_t>(clearest->step)];
    if (!clearest || clarity >= chosen + (isSmaller ? prior.smallerHandicap : 0.0)) {
      clearest = {static_cast<int>(step), clearest ? clearest->clarity : clarity};
      chosen = clarity;
    }
    clearest->clarity = std::max(clarity, clearest->clarity);
  }
  return clearest;
}

double clarityAt(const GrowthCurve& curve, int step, const StructurePrior& prior, const Grid& grid) {
  return structureClarity(curve, prior, grid)[static_cast<std::size_t>(step)];
}

double clarityBeside(const GrowthCurve& curve, double volume, const StructurePrior& prior, const Grid& grid) {
  const std::vector<double> clarities = structureClarity(curve, prior, grid);
  double greatest = clarityBeyond(curve, volume, prior, grid);
  for (std::size_t step = 1; step < clarities.size(); ++step)
    if (2.0 * curve.volume[step] <= volume) greatest = std::max(greatest, clarities[step]);
  return greatest;
}

double clarityBeyond(const GrowthCurve& curve, double volume, const StructurePrior& prior, const Grid& grid) {
  const std::vector<double> clarities = structureClarity(curve, prior, grid);
  double greatest = noClarity;
  for (std::size_t step = 1; step < clarities.size(); ++step)
    if (curve.volume[step] >= 2.0 * volume) greatest = std::max(greatest, clarities[step]);
  return greatest;
}

void beginWith(GrowthCurve& curve, int step) {
  curve.automatic = step;
  const auto holds = [step](const Plateau& each) { return each.first <= step && step <= each.last; };
  if (std::any_of(curve.plateaus.begin(), curve.plateaus.end(), holds)) return;
  const auto after = std::find_if(curve.plateaus.begin(), curve.plateaus.end(),
                                  [step](const Plateau& each) { return each.best > step; });
  curve.plateaus.insert(after, plateauAround(static_cast<std::size_t>(step), curve));
}

}  // namespace fenestra::segmentation
