#include "rendering/passes/Steps.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "rendering/gl/Context.h"

namespace fenestra {
namespace {

constexpr int groupSide = 8;
/// Steps of one pass that are told apart.
constexpr std::size_t stepsOfPass = 64;
/// Invocations of a tile whose speed is not known: some ten milliseconds of the slowest pass on a CPU, and of an old
/// graphics card.
constexpr double unknownOnCpu = 1 << 15, unknownOnCard = 1 << 18;

/// A shorter tile of fewer invocations says nothing about speed.
constexpr double leastTimed = 4.0, leastCounted = 2048.0;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

glm::ivec2 groupsOf(const gl::Region& region) { return (region.size + groupSide - 1) / groupSide; }

double invocationsOf(const gl::Region& region) {
  const glm::dvec2 groups(groupsOf(region));
  return groups.x * groups.y * groupSide * groupSide;
}

/// The first groups of a region that has more than `most`; the others stay in `left`, in one region or two.
gl::Region firstGroups(std::deque<gl::Region>& left, int most) {
  gl::Region rest = left.front(), first = rest;
  left.pop_front();
  const int across = groupsOf(rest).x, rows = most / across;
  if (rows > 0) {
    first.size.y = rows * groupSide;
    rest.origin.y += first.size.y;
    rest.size.y -= first.size.y;
    left.push_front(rest);
    return first;
  }
  // A part of the first row of groups.
  first.size = {most * groupSide, std::min(groupSide, rest.size.y)};
  gl::Region row{{rest.origin.x + first.size.x, rest.origin.y}, {rest.size.x - first.size.x, first.size.y}};
  rest.origin.y += first.size.y;
  rest.size.y -= first.size.y;
  if (rest.size.y > 0) left.push_front(rest);
  left.push_front(row);
  return first;
}

/// Whole regions and a part of the next one, of so many invocations in all, one group at least.
std::vector<gl::Region> takeTile(std::deque<gl::Region>& left, double most) {
  std::vector<gl::Region> tile;
  constexpr double group = groupSide * groupSide;
  most = std::max(most, group);
  while (!left.empty()) {
    const double wanted = invocationsOf(left.front());
    if (wanted <= most) {
      tile.push_back(left.front());
      left.pop_front();
      most -= wanted;
      continue;
    }
    if (const int groups = static_cast<int>(most / group); groups > 0) tile.push_back(firstGroups(left, groups));
    break;
  }
  return tile;
}

}  // namespace

void Steps::beginPass(std::size_t pass) {
  pass_ = pass;
  added_ = 0;
}

void Steps::add(Regions regions, Tile run) {
  Step step{pass_ * stepsOfPass + std::min(added_++, stepsOfPass - 1), {}, std::move(run), {}};
  for (const gl::Region& region : regions)
    if (region.size.x > 0 && region.size.y > 0) step.left.push_back(region);
  if (!step.left.empty()) steps_.push_back(std::move(step));
}

void Steps::add(glm::ivec2 size, Tile run) {
  const gl::Region whole{glm::ivec2(0), size};
  add(Regions(&whole, 1), std::move(run));
}

void Steps::then(std::function<void()> action) { steps_.push_back({0, {}, {}, std::move(action)}); }

double Steps::mostIn(const Step& step, double milliseconds) const {
  const auto pace = paces_.find(step.pace);
  const double slowest = pace == paces_.end() ? 0.0 : std::max(pace->second.last, pace->second.now);
  if (slowest > 0.0) return milliseconds / slowest;
  return (gl::isSoftwareRasteriser() ? unknownOnCpu : unknownOnCard) * std::min(1.0, milliseconds / shortTile);
}

void Steps::runTile(Step& step, double aim, bool limited) {
  const std::vector<gl::Region> tile = takeTile(step.left, mostIn(step, aim));
  // Without a limit, only tiles that others follow are timed: the time decides on their size.
  const bool timed = limited || !step.left.empty();
  const auto start = std::chrono::steady_clock::now();
  const std::size_t firstRuns = gl::ShaderProgram::firstRuns();
  step.run(tile);
  if (!timed) return;
  gl::finish();
  // Most of the time of a program's first run is its compilation's, and most of a small tile's is no invocation's.
  if (firstRuns != gl::ShaderProgram::firstRuns()) return;
  double invocations = 0.0;
  for (const gl::Region& region : tile) invocations += invocationsOf(region);
  const double took = millisecondsSince(start);
  if (took < leastTimed && invocations < leastCounted) return;
  Pace& pace = paces_[step.pace];
  pace.now = std::max(pace.now, took / invocations);
}

void Steps::runActions() {
  while (!steps_.empty() && steps_.front().action) {
    const std::function<void()> action = std::move(steps_.front().action);
    steps_.pop_front();
    action();
  }
}

bool Steps::advance(std::optional<double> milliseconds) {
  const auto start = std::chrono::steady_clock::now();
  const double aim = milliseconds ? std::min(*milliseconds, shortTile) : longTile;
  bool inTime = true;
  for (runActions(); inTime && !steps_.empty(); runActions()) {
    Step& step = steps_.front();
    runTile(step, aim, milliseconds.has_value());
    if (step.left.empty()) {
      if (Pace& pace = paces_[step.pace]; pace.now > 0.0) pace = {pace.now, 0.0};
      steps_.pop_front();
    }
    inTime = !milliseconds || millisecondsSince(start) < *milliseconds;
  }
  return steps_.empty();
}

}  // namespace fenestra
