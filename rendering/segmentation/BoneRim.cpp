#include "rendering/segmentation/BoneRim.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <optional>

#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr int rimWindow = 2;  ///< voxels: three do as well

enum class RimPart : std::uint8_t { Beyond, Beside, Rim, Core };

VoxelBox rimBox(std::span<const Level> joins, int step, const VoxelBox& whole) {
  VoxelBox box{whole.high, whole.low};
  for (int z = 0; z < whole.high.z; ++z)
    for (int y = 0; y < whole.high.y; ++y) {
      const auto row = joins.subspan(whole.offset({0, y, z}), static_cast<std::size_t>(whole.high.x));
      const auto holds = [step](Level level) { return level < step; };
      const auto first = std::ranges::find_if(row, holds);
      if (first == row.end()) continue;
      const auto last = std::find_if(row.rbegin(), row.rend(), holds);
      box.low = glm::min(box.low, glm::ivec3(static_cast<int>(first - row.begin()), y, z));
      box.high = glm::max(box.high, glm::ivec3(static_cast<int>(row.rend() - last), y + 1, z + 1));
    }
  return box.empty() ? box : box.grownBy(glm::ivec3(rimWindow + 1)).clippedTo(whole);
}

/// By voxel of the box. The volume's faces are no surface.
std::vector<RimPart> rimParts(std::span<const Level> joins, int step, const VoxelBox& box, const VoxelBox& whole) {
  std::vector<RimPart> parts(box.count(), RimPart::Beyond);
  const glm::ivec3 dims = box.dims();
  const auto rows = static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z);
  const auto rowAt = [&](int y, int z) -> const Level* {
    const glm::ivec3 first(box.low.x, y, z);
    return whole.contains(first) ? &joins[whole.offset(first)] : nullptr;
  };
  parallelFor(rows, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      interruptionPoint();
      const int y = box.low.y + static_cast<int>(row) % dims.y, z = box.low.z + static_cast<int>(row) / dims.y;
      const Level* const here = rowAt(y, z);
      const std::array beside{rowAt(y - 1, z), rowAt(y + 1, z), rowAt(y, z - 1), rowAt(y, z + 1)};
      RimPart* const part = &parts[row * static_cast<std::size_t>(dims.x)];
      for (int x = 0; x < dims.x; ++x) {
        const bool holds = here[x] < step;
        const auto differs = [&](Level other) { return (other < step) != holds; };
        const bool meetsOther =
            (box.low.x + x > 0 && differs(here[x - 1])) || (box.low.x + x + 1 < whole.high.x && differs(here[x + 1])) ||
            std::ranges::any_of(beside, [&](const Level* other) { return other && differs(other[x]); });
        part[x] =
            holds ? (meetsOther ? RimPart::Rim : RimPart::Core) : (meetsOther ? RimPart::Beside : RimPart::Beyond);
      }
    }
  });
  return parts;
}

struct RimMean {
  double sum = 0.0, count = 0.0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return sum / count; }
};

/// What lies beyond a voxel of the rim where that is softer than half way to the dense bone behind it, in HU.
std::optional<double> softBeyond(const Volume& volume, std::span<const RimPart> parts, const VoxelBox& box,
                                 glm::ivec3 at) {
  const VoxelBox window = VoxelBox{at - rimWindow, at + rimWindow + 1}.clippedTo(box);
  RimMean dense, beyond;
  for (int z = window.low.z; z < window.high.z; ++z)
    for (int y = window.low.y; y < window.high.y; ++y)
      for (int x = window.low.x; x < window.high.x; ++x) {
        const RimPart part = parts[box.offset({x, y, z})];
        if (part != RimPart::Core && part != RimPart::Beyond) continue;
        const double value = volume.value({x, y, z});
        if (part == RimPart::Core && value >= boneFrom) dense.add(value);
        if (part == RimPart::Beyond && value < boneFrom) beyond.add(value);
      }
  if (dense.count == 0.0 || beyond.count == 0.0) return std::nullopt;
  if (volume.value(at) >= 0.5 * (dense.value() + beyond.value())) return std::nullopt;
  return beyond.value();
}

}  // namespace

std::vector<RimVoxel> softRim(const Volume& volume, const Noise& noise, std::span<const Level> joins, int step) {
  assert(volume.isInHounsfieldUnits());
  const VoxelBox whole = wholeOf(volume.grid.dims), box = rimBox(joins, step, whole);
  if (box.empty()) return {};
  const std::vector<RimPart> parts = rimParts(joins, step, box, whole);
  const std::size_t slices = static_cast<std::size_t>(box.dims().z), ofSlice = parts.size() / slices;
  std::vector<std::vector<RimVoxel>> soft(slices);  // by slice, so that their order does not depend on the threads
  parallelFor(slices, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * ofSlice; i < end * ofSlice; ++i) {
      if (i % ofSlice == 0) interruptionPoint();
      if (parts[i] != RimPart::Rim) continue;
      const glm::ivec3 at = box.at(i);
      if (const std::optional<double> beyond = softBeyond(volume, parts, box, at))
        soft[i / ofSlice].push_back({whole.offset(at), levelOf((boneFrom - *beyond) / noise.unit)});
    }
  });
  std::vector<RimVoxel> all;
  for (const std::vector<RimVoxel>& slice : soft) all.insert(all.end(), slice.begin(), slice.end());
  return all;
}

}  // namespace fenestra::segmentation
