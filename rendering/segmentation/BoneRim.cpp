#include "rendering/segmentation/BoneRim.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/VoxelBox.h"

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
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const glm::ivec3 at = box.at(i);
    const bool holds = joins[whole.offset(at)] < step;
    bool meetsOther = false;
    for (int axis = 0; axis < 3; ++axis)
      for (const int way : {-1, 1}) {
        glm::ivec3 next = at;
        next[axis] += way;
        meetsOther = meetsOther || (whole.contains(next) && (joins[whole.offset(next)] < step) != holds);
      }
    parts[i] = holds ? (meetsOther ? RimPart::Rim : RimPart::Core) : (meetsOther ? RimPart::Beside : RimPart::Beyond);
  }
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

}  // namespace

std::vector<RimVoxel> softRim(const Volume& volume, const Noise& noise, std::span<const Level> joins, int step) {
  assert(volume.isInHounsfieldUnits());
  const VoxelBox whole = wholeOf(volume.grid.dims), box = rimBox(joins, step, whole);
  std::vector<RimVoxel> soft;
  if (box.empty()) return soft;
  const std::vector<RimPart> parts = rimParts(joins, step, box, whole);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != RimPart::Rim) continue;
    const glm::ivec3 at = box.at(i);
    const VoxelBox window = VoxelBox{at - rimWindow, at + rimWindow + 1}.clippedTo(box);
    RimMean dense, beyond;
    for (std::size_t j = 0; j < window.count(); ++j) {
      const glm::ivec3 near = window.at(j);
      const RimPart part = parts[box.offset(near)];
      if (part != RimPart::Core && part != RimPart::Beyond) continue;
      const double value = volume.value(near);
      if (part == RimPart::Core && value >= boneFrom) dense.add(value);
      if (part == RimPart::Beyond && value < boneFrom) beyond.add(value);
    }
    if (dense.count == 0.0 || beyond.count == 0.0) continue;
    if (volume.value(at) < 0.5 * (dense.value() + beyond.value()))
      soft.push_back({whole.offset(at), levelOf((boneFrom - beyond.value()) / noise.unit)});
  }
  return soft;
}

}  // namespace fenestra::segmentation
