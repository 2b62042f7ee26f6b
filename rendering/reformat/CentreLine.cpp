#include "rendering/reformat/CentreLine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "rendering/volume/DistanceTransform.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reformat {
namespace {

constexpr float unreached = std::numeric_limits<float>::infinity();

glm::ivec3 voxelAt(const Grid& grid, std::size_t offset) {
  const auto row = static_cast<std::size_t>(grid.dims.x), plane = row * static_cast<std::size_t>(grid.dims.y);
  return {static_cast<int>(offset % row), static_cast<int>(offset % plane / row), static_cast<int>(offset / plane)};
}

glm::dvec3 placeOf(const Grid& grid, std::size_t offset) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(voxelAt(grid, offset), 1.0));
}

/// Least costs of ways over the 26 neighbours within a region (E. W. Dijkstra: A note on two problems in connexion with
/// graphs, 1959), and the voxel that each was reached from.
struct Ways {
  std::vector<float> cost;
  std::vector<std::uint32_t> from;
  std::size_t farthest = 0;  ///< the voxel of the greatest cost
};

/// A step costs its length times the mean of its voxels' `weights`, or its length alone without any.
Ways waysFrom(const VoxelRegion& region, std::size_t start, const std::vector<float>& weights) {
  struct Step {
    glm::ivec3 by;
    float length;
  };
  std::vector<Step> steps;
  for (int neighbour = 0; neighbour < 27; ++neighbour) {
    const glm::ivec3 by = glm::ivec3(neighbour % 3, neighbour / 3 % 3, neighbour / 9) - 1;
    const glm::dvec3 way = region.grid.direction * (region.grid.spacing * glm::dvec3(by));
    if (by != glm::ivec3(0)) steps.push_back({by, static_cast<float>(glm::length(way))});
  }
  Ways ways{std::vector<float>(region.inside.size(), unreached), std::vector<std::uint32_t>(region.inside.size(), 0),
            start};
  using Entry = std::pair<float, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  ways.cost[start] = 0.0f;
  queue.push({0.0f, start});
  while (!queue.empty()) {
    const auto [cost, at] = queue.top();
    queue.pop();
    if (cost > ways.cost[at]) continue;
    interruptionPoint();
    ways.farthest = at;
    const glm::ivec3 voxel = voxelAt(region.grid, at);
    for (const Step& step : steps) {
      if (!region.grid.contains(voxel + step.by)) continue;
      const std::size_t next = region.grid.offset(voxel + step.by);
      if (!region.inside[next]) continue;
      const float weight = weights.empty() ? 1.0f : 0.5f * (weights[at] + weights[next]);
      const float sum = cost + weight * step.length;
      if (!(sum < ways.cost[next])) continue;
      ways.cost[next] = sum;
      ways.from[next] = static_cast<std::uint32_t>(at);
      queue.push({sum, next});
    }
  }
  return ways;
}

/// mm from each voxel's centre to the surface, which lies half a voxel before the nearest centre outside.
std::vector<float> depthsOf(const VoxelRegion& region) {
  std::vector<std::uint8_t> outside(region.inside.size());
  std::transform(region.inside.begin(), region.inside.end(), outside.begin(),
                 [](std::uint8_t in) { return in ? 0 : 1; });
  SampledLattice all;
  all.points = region.grid.dims;
  std::vector<float> depths = distancesTo(outside, region.grid, all);
  const glm::dvec3& spacing = region.grid.spacing;
  const auto half = static_cast<float>(0.5 * std::min({spacing.x, spacing.y, spacing.z}));
  // A region that fills its label map has no surface.
  const auto most = static_cast<float>(region.grid.boundingRadius());
  for (float& depth : depths) depth = std::clamp(depth - half, 0.0f, most);
  return depths;
}

/// The way to the end of `ways`, from its start.
std::vector<std::size_t> wayTo(const Ways& ways, std::size_t start, std::size_t end) {
  std::vector<std::size_t> way{end};
  while (way.back() != start) way.push_back(ways.from[way.back()]);
  std::reverse(way.begin(), way.end());
  return way;
}

/// Points `step` mm from one another along a polyline, and its last.
std::vector<glm::dvec3> spread(const std::vector<glm::dvec3>& line, double step) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  const int pieces = std::max(2, static_cast<int>(std::lround(length / step)));
  std::vector<glm::dvec3> points{line.front()};
  double passed = 0.0;
  std::size_t at = 1;
  for (int piece = 1; piece < pieces; ++piece) {
    const double target = length * piece / pieces;
    while (at + 1 < line.size() && passed + glm::distance(line[at - 1], line[at]) < target) {
      passed += glm::distance(line[at - 1], line[at]);
      ++at;
    }
    const double whole = glm::distance(line[at - 1], line[at]);
    points.push_back(
        glm::mix(line[at - 1], line[at], whole > 0.0 ? std::clamp((target - passed) / whole, 0.0, 1.0) : 0.0));
  }
  points.push_back(line.back());
  return points;
}

/// Points of the smooth curve through `points`, about `step` mm from one another, nine at least.
std::vector<glm::dvec3> along(const std::vector<glm::dvec3>& points, double step) {
  const PathCurve curve(points);
  const int pieces = std::max(8, static_cast<int>(std::lround(curve.length() / step)));
  std::vector<glm::dvec3> result;
  for (int piece = 0; piece <= pieces; ++piece) result.push_back(curve.place(curve.length() * piece / pieces).point);
  return result;
}

/// Each point but the ends between its neighbours: first towards their middle, then back by nearly as much, so that
/// bends keep their radius (G. Taubin: Curve and surface smoothing without shrinkage, ICCV 1995).
void smooth(std::vector<glm::dvec3>& points, int rounds) {
  for (int round = 0; round < rounds; ++round)
    for (const double share : {0.5, -0.52}) {
      const std::vector<glm::dvec3> before = points;
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
        points[i] += share * (0.5 * (before[i - 1] + before[i + 1]) - before[i]);
    }
}

/// Moves points to the middles of the cross-sections there.
void centre(std::vector<glm::dvec3>& points, const VoxelRegion& region, double radius) {
  const PathCurve curve(points);
  std::vector<glm::dvec3> moved = points;
  double at = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    interruptionPoint();
    if (i > 0) at += glm::distance(points[i - 1], points[i]);
    // The place of the curve nearest to the point; chords are a little shorter than the curve.
    PathPlace place = curve.place(at);
    place.point = points[i];
    const std::optional<Section> section = sectionOf(region, place, radius);
    // Where the plane cuts a bend or a branch, too, its middle is none of the tube's.
    if (section && glm::distance(section->centre, points[i]) < radius) moved[i] = section->centre;
  }
  points = std::move(moved);
}

/// Leads the line on beyond its last point, from middle to middle of the cross-sections, `step` mm each, and where the
/// region's end cuts those, straight to its surface.
void leadOut(std::vector<glm::dvec3>& points, const VoxelRegion& region, double step, double radius) {
  const glm::dvec3& spacing = region.grid.spacing;
  const double fine = 0.05 * std::min({spacing.x, spacing.y, spacing.z});
  const auto most = static_cast<std::size_t>(8.0 * radius / step) + 8;
  double area = 0.0;
  for (std::size_t added = 0; added < most; ++added) {
    // Directions over some steps, because each middle is a little off, and as much as they bend they go on bending.
    constexpr std::size_t steps = 4;
    const std::size_t last = points.size() - 1;
    const glm::dvec3 way = glm::normalize(points[last] - points[last - steps]);
    const glm::dvec3 before = glm::normalize(points[last - steps] - points[last - 2 * steps]);
    PathPlace place;
    place.along = glm::normalize(way + 0.6 * (way - before));
    place.point = points[last] + step * place.along;
    place.right = glm::normalize(
        glm::cross(place.along, std::abs(place.along.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0)));
    place.up = glm::cross(place.along, place.right);
    const bool isInside = region.at(place.point) >= 0.5;
    const std::optional<Section> section = isInside ? sectionOf(region, place, fine) : std::nullopt;
    if (!section || section->area < 0.8 * area || glm::distance(section->centre, place.point) > 0.5 * radius) {
      double straight = 0.0;
      while (straight < 2.0 * radius && region.at(points[last] + (straight + fine) * place.along) >= 0.5)
        straight += fine;
      if (straight > 0.0) points.push_back(points[last] + straight * place.along);
      return;
    }
    area = section->area;
    points.push_back(section->centre);
  }
}

}  // namespace

CentreLine centreLineOf(const VoxelRegion& region) {
  CentreLine line;
  const auto any = std::find(region.inside.begin(), region.inside.end(), 1);
  if (any == region.inside.end()) return line;
  const std::size_t first = waysFrom(region, static_cast<std::size_t>(any - region.inside.begin()), {}).farthest;
  const Ways farther = waysFrom(region, first, {});
  const std::size_t second = farther.farthest;

  const std::vector<float> depths = depthsOf(region);
  const float deepest = *std::max_element(depths.begin(), depths.end());
  // A ball is twice as long as it is deep.
  constexpr float leastLength = 2.6f;
  if (farther.cost[second] < leastLength * deepest) return line;
  std::vector<float> weights(depths.size());
  // A thousandth of the greatest keeps voxels of the surface from costing without end.
  std::transform(depths.begin(), depths.end(), weights.begin(), [&](float depth) {
    const float share = std::max(depth / std::max(deepest, 1e-6f), 0.03f);
    return 1.0f / (share * share);
  });
  const std::vector<std::size_t> way = wayTo(waysFrom(region, first, weights), first, second);
  // The way comes to its ends from the middle, across the tube: what lies within the tube's radius of an end is not its
  // middle.
  std::vector<float> passed;
  for (const std::size_t voxel : way) passed.push_back(depths[voxel]);
  std::nth_element(passed.begin(), passed.begin() + static_cast<std::ptrdiff_t>(passed.size() / 2), passed.end());
  line.radius = static_cast<double>(passed[passed.size() / 2]);
  const glm::dvec3 ends[2] = {placeOf(region.grid, first), placeOf(region.grid, second)};
  std::vector<glm::dvec3> middle;
  for (const std::size_t voxel : way) {
    const glm::dvec3 place = placeOf(region.grid, voxel);
    if (std::min(glm::distance(place, ends[0]), glm::distance(place, ends[1])) > 1.8 * line.radius)
      middle.push_back(place);
  }
  if (middle.size() < 3 || !(line.radius > 0.0)) return line;

  const glm::dvec3& spacing = region.grid.spacing;
  const double step = std::max(line.radius, 2.0 * std::min({spacing.x, spacing.y, spacing.z}));
  std::vector<glm::dvec3> points = spread(middle, 0.5 * step);
  smooth(points, 10);
  for (int round = 0; round < 3; ++round) {
    centre(points, region, 2.0 * line.radius + step);
    points = along(points, step);
    smooth(points, 8);
  }
  points = along(points, 0.25 * step);
  for (int end = 0; end < 2; ++end) {
    leadOut(points, region, 0.25 * step, line.radius + step);
    std::reverse(points.begin(), points.end());
  }
  // Between bends as tight as twice the tube's radius, its middle is twice as long as the way along their insides. In a
  // blob, middles of cross-sections lie here and there, and a line through them is far longer.
  constexpr double mostLength = 2.0;
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i], points[i - 1]);
  if (length > mostLength * static_cast<double>(farther.cost[second])) return line;
  if (points.front().z < points.back().z) std::reverse(points.begin(), points.end());
  line.points = std::move(points);
  return line;
}

}  // namespace fenestra::reformat
