#include "rendering/reformat/Region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "rendering/volume/Threads.h"

namespace fenestra::reformat {
namespace {

/// Keeps the largest 26-connected part.
void keepLargest(VoxelRegion& region) {
  const glm::ivec3 dims = region.grid.dims;
  std::vector<std::uint32_t> part(region.inside.size(), 0);
  std::vector<std::size_t> waiting;
  std::uint32_t parts = 0, largest = 0;
  std::size_t most = 0;
  for (std::size_t seed = 0; seed < region.inside.size(); ++seed) {
    if (!region.inside[seed] || part[seed]) continue;
    part[seed] = ++parts;
    waiting.assign(1, seed);
    std::size_t count = 0;
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      // A look at each voxel would cost more than its neighbours do.
      if (++count % 4096 == 0) interruptionPoint();
      const auto row = static_cast<std::size_t>(dims.x), plane = row * static_cast<std::size_t>(dims.y);
      const glm::ivec3 voxel(static_cast<int>(at % row), static_cast<int>(at % plane / row),
                             static_cast<int>(at / plane));
      for (int neighbour = 0; neighbour < 27; ++neighbour) {
        const glm::ivec3 next = voxel + glm::ivec3(neighbour % 3, neighbour / 3 % 3, neighbour / 9) - 1;
        if (!region.grid.contains(next)) continue;
        const std::size_t offset = region.grid.offset(next);
        if (!region.inside[offset] || part[offset]) continue;
        part[offset] = parts;
        waiting.push_back(offset);
      }
    }
    if (count > most) {
      most = count;
      largest = parts;
    }
  }
  for (std::size_t i = 0; i < part.size(); ++i) region.inside[i] = part[i] == largest && part[i] != 0;
}

/// Squares of a plane about a place, and which of them were reached from it.
class Squares {
 public:
  Squares(const VoxelRegion& region, const PathPlace& place, double side, int half)
      : region_(region),
        place_(place),
        side_(side),
        half_(half),
        width_(2 * half + 1),
        state_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(width_), unknown) {}

  /// False where the section goes on beyond the squares.
  bool fill(glm::ivec2 from, Section& section) {
    std::vector<glm::ivec2> waiting{from};
    state(from) = taken;
    std::size_t count = 0;
    glm::dvec2 sum(0.0);
    while (!waiting.empty()) {
      const glm::ivec2 at = waiting.back();
      waiting.pop_back();
      if (std::max(std::abs(at.x), std::abs(at.y)) == half_) return false;
      ++count;
      sum += glm::dvec2(at);
      for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const glm::ivec2 next = at + step;
        if (state(next) != unknown) continue;
        state(next) = taken;
        if (isInside(next)) waiting.push_back(next);
      }
    }
    section.area = static_cast<double>(count) * side_ * side_;
    section.centre = point(sum / static_cast<double>(count));
    return true;
  }

  bool isInside(glm::ivec2 at) const { return region_.at(point(glm::dvec2(at))) >= 0.5; }

 private:
  static constexpr std::uint8_t unknown = 0, taken = 1;

  glm::dvec3 point(glm::dvec2 at) const { return place_.point + side_ * (at.x * place_.right + at.y * place_.up); }
  std::uint8_t& state(glm::ivec2 at) {
    return state_[static_cast<std::size_t>(at.y + half_) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(at.x + half_)];
  }

  const VoxelRegion& region_;
  const PathPlace& place_;
  const double side_;
  const int half_, width_;
  std::vector<std::uint8_t> state_;
};

/// The square of the region nearest to the middle, at most `most` squares away.
std::optional<glm::ivec2> nearestInside(const Squares& squares, int most) {
  for (int ring = 0; ring <= most; ++ring) {
    std::optional<glm::ivec2> nearest;
    for (int y = -ring; y <= ring; ++y)
      for (int x = -ring; x <= ring; x += std::abs(y) == ring || ring == 0 ? 1 : 2 * ring) {
        const glm::ivec2 at(x, y);
        if (nearest && x * x + y * y >= nearest->x * nearest->x + nearest->y * nearest->y) continue;
        if (squares.isInside(at)) nearest = at;
      }
    if (nearest) return nearest;
  }
  return std::nullopt;
}

}  // namespace

double VoxelRegion::at(glm::dvec3 point) const {
  const glm::dvec3 index = toIndex * (point - grid.origin);
  if (!glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) ||
      !glm::all(glm::lessThanEqual(index, glm::dvec3(grid.dims) - 0.5)))
    return 0.0;
  return interpolated(grid, index, [&](glm::ivec3 voxel) { return static_cast<double>(inside[grid.offset(voxel)]); });
}

VoxelRegion regionOf(const LabelMap& labels, std::span<const std::uint16_t> values) {
  std::vector<bool> wanted(65536, false);
  for (const std::uint16_t value : values) wanted[value] = true;
  const Grid& grid = labels.grid;
  glm::ivec3 first = grid.dims, last(-1);
  VoxelRegion region;
  labels.voxels.visit([&](auto scalars) {
    const auto isWanted = [&](std::size_t at) { return wanted[static_cast<std::uint16_t>(scalars[at])]; };
    std::size_t at = 0;
    for (int z = 0; z < grid.dims.z; ++z) {
      interruptionPoint();
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x, ++at)
          if (isWanted(at)) {
            first = glm::min(first, {x, y, z});
            last = glm::max(last, {x, y, z});
          }
    }
    if (last.x < 0) return;
    first = glm::max(first - 1, glm::ivec3(0));
    last = glm::min(last + 1, grid.dims - 1);
    region.grid = grid;
    region.grid.dims = last - first + 1;
    region.grid.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(first, 1.0));
    region.toIndex = glm::dmat3(region.grid.indexFromWorld());
    for (int z = first.z; z <= last.z; ++z) {
      interruptionPoint();
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) region.inside.push_back(isWanted(grid.offset({x, y, z})));
    }
  });
  if (!region.isEmpty()) keepLargest(region);
  return region;
}

double Section::radius() const { return std::sqrt(area / std::numbers::pi); }

std::optional<Section> sectionOf(const VoxelRegion& region, const PathPlace& place, double reach) {
  const glm::dvec3& spacing = region.grid.spacing;
  const double side = 0.25 * std::min({spacing.x, spacing.y, spacing.z});
  const int away = static_cast<int>(std::ceil(reach / side));
  // The squares grow until the section lies within them, at most to the region's own size.
  const int most = static_cast<int>(std::ceil(2.0 * region.grid.boundingRadius() / side)) + 2;
  for (int half = std::min(std::max(64, 2 * away), most);; half = std::min(2 * half, most)) {
    Squares squares(region, place, side, half);
    const std::optional<glm::ivec2> start = nearestInside(squares, std::min(away, half - 1));
    if (!start) return std::nullopt;
    Section section;
    if (squares.fill(*start, section)) return section;
    if (half == most) return std::nullopt;
  }
}

}  // namespace fenestra::reformat
