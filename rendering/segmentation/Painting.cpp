#include "rendering/segmentation/Painting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

/// mm between a point and the nearest one of a line.
double distanceTo(glm::dvec3 begin, glm::dvec3 end, glm::dvec3 point) {
  const glm::dvec3 along = end - begin, from = point - begin;
  const double square = glm::dot(along, along);
  const double share = square > 0.0 ? std::clamp(glm::dot(from, along) / square, 0.0, 1.0) : 0.0;
  return glm::length(from - share * along);
}

/// The voxels that a ball along a line from one place to another may hold, within the grid.
VoxelBox boxAlong(glm::dvec3 begin, glm::dvec3 end, double radius, const Grid& grid) {
  const glm::dmat4 indexFromWorld = grid.indexFromWorld();
  // A ball reaches so far along each axis of the index: the length of that row times the radius.
  glm::dvec3 reach;
  for (int axis = 0; axis < 3; ++axis)
    reach[axis] =
        radius * glm::length(glm::dvec3(indexFromWorld[0][axis], indexFromWorld[1][axis], indexFromWorld[2][axis]));
  const glm::dvec3 a(indexFromWorld * glm::dvec4(begin, 1.0)), b(indexFromWorld * glm::dvec4(end, 1.0));
  // Limited before they are rounded: a far position has no int.
  const glm::dvec3 last(grid.dims);
  return {glm::ivec3(glm::ceil(glm::clamp(glm::min(a, b) - reach, glm::dvec3(0.0), last))),
          glm::ivec3(glm::floor(glm::clamp(glm::max(a, b) + reach + 1.0, glm::dvec3(0.0), last)))};
}

/// A line of a stroke; a dab's runs from its point to itself.
struct Line {
  glm::dvec3 begin, end;
  VoxelBox box;
};

std::vector<Line> linesOf(const SelectionStroke& stroke, const Grid& grid) {
  std::vector<Line> lines;
  const std::vector<glm::dvec3>& anchors = stroke.anchors;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (i + 1 == anchors.size() && i > 0) break;
    const glm::dvec3 end = anchors[std::min(i + 1, anchors.size() - 1)];
    lines.push_back({anchors[i], end, boxAlong(anchors[i], end, stroke.radius, grid)});
  }
  return lines;
}

/// A voxel within the radius.
struct StrokeReach {
  glm::ivec3 voxel;
  double distance;
};

/// The voxels that a stroke reaches, in the order of the grid. Uses all cores, each for a plane of the grid at a time.
std::vector<StrokeReach> reachedBy(const SelectionStroke& stroke, const Grid& grid) {
  const VoxelBox box = boxOf(stroke, grid);
  if (box.empty()) return {};
  const std::vector<Line> lines = linesOf(stroke, grid);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  std::vector<std::vector<StrokeReach>> planes(static_cast<std::size_t>(box.dims().z));
  const auto width = static_cast<std::size_t>(box.dims().x);
  parallelFor(planes.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> least;
    for (std::size_t plane = begin; plane < end; ++plane) {
      interruptionPoint();
      const int z = box.low.z + static_cast<int>(plane);
      least.assign(width * static_cast<std::size_t>(box.dims().y), std::numeric_limits<double>::infinity());
      const auto at = [&](int x, int y) -> double& {
        return least[static_cast<std::size_t>(x - box.low.x) + width * static_cast<std::size_t>(y - box.low.y)];
      };
      for (const Line& line : lines) {
        if (z < line.box.low.z || z >= line.box.high.z) continue;
        for (int y = line.box.low.y; y < line.box.high.y; ++y)
          for (int x = line.box.low.x; x < line.box.high.x; ++x)
            at(x, y) = std::min(
                at(x, y), distanceTo(line.begin, line.end, glm::dvec3(worldFromIndex * glm::dvec4(x, y, z, 1.0))));
      }
      for (int y = box.low.y; y < box.high.y; ++y)
        for (int x = box.low.x; x < box.high.x; ++x)
          if (at(x, y) <= stroke.radius) planes[plane].push_back({{x, y, z}, at(x, y)});
    }
  });
  std::vector<StrokeReach> reached;
  for (const std::vector<StrokeReach>& plane : planes) reached.insert(reached.end(), plane.begin(), plane.end());
  return reached;
}

/// v̄ of voxelsOf().
double meanWithin(double core, const std::vector<StrokeReach>& reached, const Volume& volume) {
  double sum = 0.0, count = 0.0;
  for (const StrokeReach& each : reached)
    if (const double value = volume.value(each.voxel); each.distance <= core && std::isfinite(value)) {
      sum += value;
      ++count;
    }
  if (count > 0.0) return sum / count;
  const auto nearest = std::min_element(reached.begin(), reached.end(), [](const StrokeReach& a, const StrokeReach& b) {
    return a.distance < b.distance;
  });
  return nearest == reached.end() ? std::numeric_limits<double>::quiet_NaN() : volume.value(nearest->voxel);
}

}  // namespace

VoxelBox boxOf(const SelectionStroke& stroke, const Grid& grid) {
  VoxelBox whole;
  for (const Line& line : linesOf(stroke, grid)) {
    if (line.box.empty()) continue;
    whole = whole.empty() ? line.box : VoxelBox{glm::min(whole.low, line.box.low), glm::max(whole.high, line.box.high)};
  }
  return whole;
}

std::vector<std::size_t> voxelsOf(const SelectionStroke& stroke, const Volume& volume, double noise) {
  const std::vector<StrokeReach> reached = reachedBy(stroke, volume.grid);
  const double core = (1.0 - stroke.softness) * stroke.radius;
  const double mean = stroke.softness > 0.0 ? meanWithin(core, reached, volume) : 0.0;
  std::vector<std::size_t> voxels;
  for (const StrokeReach& each : reached) {
    const bool inRim = each.distance > core;
    const double difference = inRim ? std::abs(volume.value(each.voxel) - mean) : 0.0;
    if (!inRim || difference * (each.distance - core) <= alike * noise * (stroke.radius - each.distance))
      voxels.push_back(volume.grid.offset(each.voxel));
  }
  return voxels;
}

void paint(std::span<std::uint8_t> steps, std::span<double> countOf, const Volume& volume, double noise,
           std::span<const SelectionStroke> strokes) {
  // Step n holds the voxels whose first step is 1 to n.
  std::vector<double> joined(countOf.size() + 1, 0.0);
  for (const SelectionStroke& stroke : strokes)
    for (const std::size_t voxel : voxelsOf(stroke, volume, noise)) {
      const auto after = static_cast<std::uint8_t>(stroke.adds ? 1 : 0);
      if (steps[voxel] > 0) --joined[steps[voxel]];
      if (after > 0) ++joined[after];
      steps[voxel] = after;
    }
  double sum = 0.0;
  for (std::size_t step = 1; step < countOf.size(); ++step) countOf[step] += sum += joined[step];
}

}  // namespace fenestra::segmentation
