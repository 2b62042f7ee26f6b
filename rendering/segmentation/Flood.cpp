#include "rendering/segmentation/Flood.h"

#include <algorithm>
#include <array>

namespace fenestra::segmentation {
namespace {

/// Voxels by the level at which they are reached; two kinds of seeds.
class Flooding {
 public:
  /// Seeds start at `start` at least.
  Flooding(const FloodSource& inside, const FloodSource& outside, Level start)
      : sources_{&inside, &outside}, result_{PaddedLevels(inside.costs->dims()), {}} {
    const auto width = static_cast<std::ptrdiff_t>(inside.costs->dims().x + 2);
    const auto slice = width * static_cast<std::ptrdiff_t>(inside.costs->dims().y + 2);
    steps_ = {-1, 1, -width, width, -slice, slice};
    if (outside.costs) result_.outside.assign(result_.reached.all().size(), 0);
    for (std::uint8_t kind = 0; kind < 2; ++kind)
      for (const glm::ivec3 seed : sources_[kind]->seeds) {
        const std::size_t at = result_.reached.offset(seed);
        reach(at, kind, std::max(start, sources_[kind]->costs->all()[at]));
      }
  }

  /// Breadth first within a level, so that of equal levels the fewer steps win.
  void run(int level) {
    ring_.swap(waiting_[static_cast<std::size_t>(level)]);
    while (!ring_.empty()) {
      for (const std::size_t at : ring_) spread(at, static_cast<Level>(level));
      // What was reached at this level is the next ring.
      ring_.clear();
      ring_.swap(waiting_[static_cast<std::size_t>(level)]);
    }
    std::vector<std::size_t>().swap(waiting_[static_cast<std::size_t>(level)]);
  }

  /// How many voxels have been spread from.
  std::size_t spreadCount() const { return spread_; }
  Flooded take() { return std::move(result_); }

 private:
  void reach(std::size_t at, std::uint8_t kind, Level level) {
    Level& reached = result_.reached.all()[at];
    if (level >= reached) return;
    reached = level;
    if (!result_.outside.empty()) result_.outside[at] = kind;
    waiting_[level].push_back(at);
  }

  void spread(std::size_t from, Level level) {
    // Reached at a lower level since it was put here.
    if (result_.reached.all()[from] != level) return;
    ++spread_;
    const std::uint8_t kind = result_.outside.empty() ? std::uint8_t{0} : result_.outside[from];
    const std::vector<Level>& costs = sources_[kind]->costs->all();
    for (const std::ptrdiff_t step : steps_) {
      const std::size_t to = from + static_cast<std::size_t>(step);
      reach(to, kind, std::max(level, costs[to]));
    }
  }

  std::array<const FloodSource*, 2> sources_;
  std::array<std::ptrdiff_t, 6> steps_{};
  Flooded result_;
  std::array<std::vector<std::size_t>, levelCount> waiting_;
  std::vector<std::size_t> ring_;
  std::size_t spread_ = 0;
};

/// The level at which seeds have left the noise around them: where they reach more voxels than a basin of the noise
/// has, and a little more. 0 when that takes a larger cost than noise does; a thin structure has no more voxels.
Level escapeLevel(const FloodSource& source) {
  constexpr std::size_t basin = 2000;
  constexpr double largest = 1.0;  // noise units; smoothed noise is a third of one
  // Just where the noise lets seeds out, their ways are few and winding, and so is the surface between two seeds.
  constexpr double margin = 0.25;  // noise units
  Flooding flooding(source, {}, 0);
  for (int level = 0; costOf(level) <= largest; ++level) {
    flooding.run(level);
    if (flooding.spreadCount() > basin) return levelOf(costOf(level) + margin);
  }
  return 0;
}

}  // namespace

Flooded flood(const FloodSource& inside, const FloodSource& outside, const std::function<bool(double)>& goOn) {
  const Level start = outside.costs ? std::max(escapeLevel(inside), escapeLevel(outside)) : Level{0};
  Flooding flooding(inside, outside, start);
  for (int level = 0; level < levelCount; ++level) {
    if (!goOn(static_cast<double>(level) / levelCount)) break;
    flooding.run(level);
  }
  return flooding.take();
}

}  // namespace fenestra::segmentation
