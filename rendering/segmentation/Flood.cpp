#include "rendering/segmentation/Flood.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fenestra::segmentation {
namespace {

/// One kind of seeds. Within a level the order does not matter, so a voxel brings along the run of voxels beside it,
/// and runs find each other as rows do, next to each other in memory: some three times as fast as voxel by voxel.
/// `Index` counts the voxels: the smaller it is, the less memory is read.
template <class Index>
class RunFlooding {
 public:
  explicit RunFlooding(const FloodSource& source)
      : open_(*source.costs), reached_(source.costs->dims()), levels_(reached_.all().data()) {
    const auto width = static_cast<Index>(source.costs->dims().x + 2);
    const auto slice = static_cast<Index>(width * static_cast<Index>(source.costs->dims().y + 2));
    // Unsigned numbers wrap around: adding one of the last two goes back.
    rows_ = {width, slice, static_cast<Index>(Index{0} - width), static_cast<Index>(Index{0} - slice)};
    for (const glm::ivec3 seed : source.seeds) {
      const auto at = static_cast<Index>(reached_.offset(seed));
      if (open_.all()[at] != never) wait(open_.all().data(), at);
    }
  }

  void run(int level) {
    level_ = static_cast<Level>(level);
    std::vector<Index>& waiting = waiting_[level_];
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (i + ahead < waiting.size()) fetch(waiting[i + ahead]);
      spreadFrom(waiting[i]);
      while (!joining_.empty()) {
        const Index next = joining_.back();
        joining_.pop_back();
        if (open_.all()[next] == never) continue;  // another run has brought it along
        open_.all()[next] = never;
        levels_[next] = level_;
        spreadFrom(next);
      }
    }
    std::vector<Index>().swap(waiting);
  }

  PaddedLevels take() { return std::move(reached_); }

 private:
  /// Reaches a voxel later, at its own cost.
  void wait(Level* open, Index at) {
    const Level cost = std::exchange(open[at], never);
    levels_[at] = cost;
    waiting_[cost].push_back(at);
  }

  /// Asks for the memory that spreadFrom() reads: rows beside each other are far apart there.
  void fetch(Index at) const {
    const Level* const open = open_.all().data();
    __builtin_prefetch(open + at);
    for (const Index row : rows_) __builtin_prefetch(open + static_cast<Index>(at + row));
  }

  /// From a voxel that is reached at this level, along its row and into the four rows beside it.
  void spreadFrom(Index at) {
    // Bytes that are written may be anything to a compiler: it would read the members again after each.
    Level* const levels = levels_;
    Level* const open = open_.all().data();
    const Level level = level_;
    Index first = at, last = at;
    while (open[first - 1] <= level) {
      open[--first] = never;
      levels[first] = level;
    }
    while (open[last + 1] <= level) {
      open[++last] = never;
      levels[last] = level;
    }
    if (open[first - 1] != never) wait(open, first - 1);
    if (open[last + 1] != never) wait(open, last + 1);
    for (const Index row : rows_) {
      bool isInRun = false;
      const Index end = last + row + 1;
      for (Index i = first + row; i != end; ++i) {
        const Level cost = open[i];
        const bool joining = cost <= level;
        if (joining && !isInRun) {
          joining_.push_back(i);
          fetch(i);
        }
        if (!joining && cost != never) wait(open, i);
        isInRun = joining;
      }
    }
  }

  PaddedLevels open_;  ///< costs of what is not reached yet; never: all else
  PaddedLevels reached_;
  Level* levels_;
  std::array<Index, 4> rows_{};
  Level level_ = 0;
  std::array<std::vector<Index>, levelCount> waiting_;
  std::vector<Index> joining_;  ///< reached at this level, one of each run
};

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

  /// Breadth first within a level, so that at equal levels fewer steps win.
  void run(int level) {
    ring_.swap(waiting_[static_cast<std::size_t>(level)]);
    while (!ring_.empty()) {
      for (const std::size_t at : ring_) spread(at, static_cast<Level>(level));
      // The voxels reached at this level are the next ring.
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
    // The voxel has been reached at a lower level since it was put here.
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
  const auto runAll = [&](auto& flooding) {
    for (int level = 0; level < levelCount; ++level) {
      if (!goOn(static_cast<double>(level) / levelCount)) break;
      flooding.run(level);
    }
  };
  if (!outside.costs) {
    const auto run = [&](auto flooding) -> Flooded {
      runAll(flooding);
      return {flooding.take(), {}};
    };
    return inside.costs->all().size() <= UINT32_MAX ? run(RunFlooding<std::uint32_t>(inside))
                                                    : run(RunFlooding<std::size_t>(inside));
  }
  Flooding flooding(inside, outside, std::max(escapeLevel(inside), escapeLevel(outside)));
  runAll(flooding);
  return flooding.take();
}

}  // namespace fenestra::segmentation
