#include "rendering/segmentation/Mask.h"

#include <algorithm>
#include <array>
#include <mutex>

#include "rendering/segmentation/Morphology.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr std::size_t grain = 1u << 20;

/// Consecutive offsets along x of a ball.
struct BallRow {
  int x = 0, y = 0, z = 0, length = 0;
};

std::vector<BallRow> ballRows(const Grid& grid, double radius) {
  std::vector<BallRow> rows;
  for (const glm::ivec3 offset : ballOffsets(grid, radius)) {
    if (!rows.empty() && rows.back().y == offset.y && rows.back().z == offset.z)
      ++rows.back().length;
    else
      rows.push_back({offset.x, offset.y, offset.z, 1});
  }
  return rows;
}

/// Calls visit(neighbour) for the up to 26 neighbours in `box`.
template <class Visit>
void forNeighbours(glm::ivec3 index, const VoxelBox& box, Visit visit) {
  const VoxelBox around = VoxelBox{index - 1, index + 2}.clippedTo(box);
  glm::ivec3 at;
  for (at.z = around.low.z; at.z < around.high.z; ++at.z)
    for (at.y = around.low.y; at.y < around.high.y; ++at.y)
      for (at.x = around.low.x; at.x < around.high.x; ++at.x)
        if (at != index) visit(at);
}

template <class Visit>
void forVoxels(const VoxelBox& box, Visit visit) {
  glm::ivec3 at;
  for (at.z = box.low.z; at.z < box.high.z; ++at.z)
    for (at.y = box.low.y; at.y < box.high.y; ++at.y)
      for (at.x = box.low.x; at.x < box.high.x; ++at.x) visit(at);
}

/// Sets the balls around the voxels of `within` that are `value` to `value`. Only the balls of voxels at the surface
/// are set: those of voxels inside would change nothing more.
Mask spread(const Mask& mask, const VoxelBox& within, std::uint8_t value, double radius) {
  Mask result = mask;
  const Grid& grid = mask.grid;
  const VoxelBox whole = wholeOf(grid.dims);
  const std::vector<BallRow> rows = ballRows(grid, radius);
  forVoxels(within, [&](glm::ivec3 at) {
    if (mask.voxels[grid.offset(at)] != value) return;
    bool surface = false;
    forNeighbours(at, whole, [&](glm::ivec3 next) { surface = surface || mask.voxels[grid.offset(next)] != value; });
    if (!surface) return;
    for (const BallRow& row : rows) {
      const glm::ivec3 low = at + glm::ivec3(row.x, row.y, row.z);
      const int first = std::max(low.x, 0), last = std::min(low.x + row.length, grid.dims.x);
      if (low.y < 0 || low.y >= grid.dims.y || low.z < 0 || low.z >= grid.dims.z || first >= last) continue;
      std::fill_n(result.voxels.begin() + static_cast<std::ptrdiff_t>(grid.offset({first, low.y, low.z})), last - first,
                  value);
    }
  });
  return result;
}

/// The 26-connected parts of a mask, as lists of offsets, in the order of their first voxel.
std::vector<std::vector<std::size_t>> partsOf(const Mask& mask) {
  std::vector<std::vector<std::size_t>> parts;
  std::vector<std::uint8_t> left = mask.voxels;
  const VoxelBox whole = wholeOf(mask.grid.dims);
  forVoxels(boundsOf(mask), [&](glm::ivec3 start) {
    if (!left[mask.grid.offset(start)]) return;
    std::vector<std::size_t>& part = parts.emplace_back();
    const auto take = [&](glm::ivec3 at) {
      const std::size_t offset = mask.grid.offset(at);
      if (left[offset]) part.push_back(offset);
      left[offset] = 0;
    };
    take(start);
    for (std::size_t i = 0; i < part.size(); ++i) forNeighbours(whole.at(part[i]), whole, take);
  });
  return parts;
}

/// The mask of the parts that `keep` holds for.
template <class Keep>
Mask keptParts(const Mask& mask, const std::vector<std::vector<std::size_t>>& parts, Keep keep) {
  Mask result{mask.grid, std::vector<std::uint8_t>(mask.voxels.size(), 0)};
  for (const std::vector<std::size_t>& part : parts)
    if (keep(part))
      for (const std::size_t offset : part) result.voxels[offset] = 1;
  return result;
}

}  // namespace

Mask maskAt(const Growth& growth, int step) {
  Mask mask;
  setMask(mask, growth, step);
  return mask;
}

void setMask(Mask& mask, const Growth& growth, int step) {
  const auto steps = growth.steps->voxels.as<std::uint8_t>();
  mask.grid = growth.steps->grid;
  mask.voxels.resize(steps.size());
  // 0, no step, wraps to 255, so that one comparison is enough.
  const auto last = static_cast<std::uint8_t>(std::clamp(step, 0, stepCount));
  parallelFor(steps.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) mask.voxels[i] = static_cast<std::uint8_t>(steps[i] - 1) < last;
  });
}

Mask maskOf(const LabelMap& labels, std::uint16_t label) {
  Mask mask{labels.grid, std::vector<std::uint8_t>(labels.voxels.count())};
  labels.voxels.visit([&](auto values) {
    parallelFor(values.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) mask.voxels[i] = static_cast<std::uint16_t>(values[i]) == label;
    });
  });
  return mask;
}

std::shared_ptr<const LabelMap> labelMapOf(const Mask& mask, const Label& label) {
  auto labels = std::make_shared<LabelMap>();
  labels->grid = mask.grid;
  labels->labels = {label};
  labels->voxels = Voxels(label.value < 256 ? ScalarType::UInt8 : ScalarType::UInt16, mask.voxels.size());
  const auto fill = [&](auto values) {
    using T = typename decltype(values)::value_type;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = mask.voxels[i] ? static_cast<T>(label.value) : T{0};
  };
  label.value < 256 ? fill(labels->voxels.as<std::uint8_t>()) : fill(labels->voxels.as<std::uint16_t>());
  return labels;
}

std::shared_ptr<const LabelMap> focusLabel(const Scene& scene, const Label& label) {
  std::vector<std::uint8_t> wanted(65536, 0);
  for (const std::uint16_t value : std::get<LabelFocus>(scene.look.focus).labels) wanted[value] = 1;
  Mask mask{scene.labels->grid, std::vector<std::uint8_t>(scene.labels->voxels.count())};
  scene.labels->voxels.visit([&](auto values) {
    parallelFor(values.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) mask.voxels[i] = wanted[static_cast<std::uint16_t>(values[i])];
    });
  });
  return labelMapOf(mask, label);
}

VoxelBox boundsOf(const Mask& mask) {
  const glm::ivec3 dims = mask.grid.dims;
  VoxelBox bounds{dims, glm::ivec3(0)};
  std::mutex mutex;
  parallelFor(static_cast<std::size_t>(dims.z), 4, [&](std::size_t begin, std::size_t end) {
    VoxelBox local{dims, glm::ivec3(0)};
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < dims.y; ++y) {
        const std::uint8_t* row = mask.voxels.data() + mask.grid.offset({0, y, z});
        const int first = static_cast<int>(std::find(row, row + dims.x, 1) - row);
        if (first == dims.x) continue;
        int last = dims.x;
        while (!row[last - 1]) --last;
        local = {glm::min(local.low, glm::ivec3(first, y, z)), glm::max(local.high, glm::ivec3(last, y + 1, z + 1))};
      }
    const std::scoped_lock lock(mutex);
    bounds = {glm::min(bounds.low, local.low), glm::max(bounds.high, local.high)};
  });
  return bounds.empty() ? VoxelBox{} : bounds;
}

double volumeOf(const Mask& mask) {
  return static_cast<double>(std::count(mask.voxels.begin(), mask.voxels.end(), 1)) * mask.grid.voxelVolume();
}

Mask grown(const Mask& mask, double distance) { return spread(mask, boundsOf(mask), 1, distance); }

Mask shrunk(const Mask& mask, double distance) {
  const VoxelBox near = boundsOf(mask).grownBy(glm::ivec3(1)).clippedTo(wholeOf(mask.grid.dims));
  return spread(mask, near, 0, distance);
}

Mask withHolesFilled(const Mask& mask) {
  const VoxelBox whole = wholeOf(mask.grid.dims);
  const VoxelBox box = boundsOf(mask).grownBy(glm::ivec3(1)).clippedTo(whole);
  std::vector<std::uint8_t> open(box.count(), 0);
  std::vector<glm::ivec3> front;
  const auto reach = [&](glm::ivec3 at) {
    if (!box.contains(at) || open[box.offset(at)] || mask.voxels[mask.grid.offset(at)]) return;
    open[box.offset(at)] = 1;
    front.push_back(at);
  };
  forVoxels(box, [&](glm::ivec3 at) {
    if (glm::any(glm::equal(at, box.low)) || glm::any(glm::equal(at, box.high - 1))) reach(at);
  });
  while (!front.empty()) {
    const glm::ivec3 from = front.back();
    front.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 step(0);
      step[axis] = 1;
      reach(from - step);
      reach(from + step);
    }
  }
  Mask result = mask;
  forVoxels(box, [&](glm::ivec3 at) {
    if (!open[box.offset(at)]) result.voxels[mask.grid.offset(at)] = 1;
  });
  return result;
}

Mask withoutIslands(const Mask& mask, double leastVolume) {
  const double voxel = mask.grid.voxelVolume();
  return keptParts(mask, partsOf(mask),
                   [&](const auto& part) { return static_cast<double>(part.size()) * voxel >= leastVolume; });
}

Mask largestPart(const Mask& mask) {
  const auto parts = partsOf(mask);
  const auto largest =
      std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return keptParts(mask, parts, [&](const auto& part) { return &part == &*largest; });
}

}  // namespace fenestra::segmentation
