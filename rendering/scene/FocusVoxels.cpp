#include "rendering/scene/FocusVoxels.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "rendering/scene/FocusCells.h"
#include "rendering/scene/Scene.h"
#include "rendering/volume/Threads.h"

namespace fenestra {

FocusVoxels::FocusVoxels(const Scene& scene) : worldFromIndex_(scene.volume->grid.worldFromIndex()) {
  const Grid& grid = scene.volume->grid;
  if (const auto* focus = std::get_if<LabelFocus>(&scene.look.focus); focus && scene.labels) {
    std::vector<std::uint8_t> inFocus(std::numeric_limits<std::uint16_t>::max() + 1);
    for (const std::uint16_t label : focus->labels) inFocus[label] = 1;
    scene.labels->voxels.visit([&](auto labels) {
      find(grid.dims,
           [&](glm::ivec3 voxel) { return inFocus[static_cast<std::uint16_t>(labels[grid.offset(voxel)])] != 0; });
    });
  } else if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus)) {
    const ShownVolume shown = shownVolume(scene);
    const ShownVoxels voxels(shown);
    const FocusCells cells = focusCells(shown, *values);
    withValues(shown, [&](auto valueAt) {
      find(grid.dims, [&](glm::ivec3 voxel) {
        const double value = valueAt(voxel);
        if (!(value >= values->values.low && value <= values->values.high) || voxels.isGone(voxel)) return false;
        for (int corner = 0; corner < 8; ++corner)
          if (cells.contains(voxel - glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2))) return true;
        return false;
      });
    });
  }
}

template <class Holds>
void FocusVoxels::find(glm::ivec3 dims, const Holds& holds) {
  std::mutex mutex;
  glm::ivec3 first = dims, last(-1);
  parallelFor(static_cast<std::size_t>(dims.z), 4, [&](std::size_t begin, std::size_t end) {
    glm::ivec3 low = dims, high(-1), voxel;
    for (voxel.z = static_cast<int>(begin); voxel.z < static_cast<int>(end); ++voxel.z)
      for (voxel.y = 0; voxel.y < dims.y; ++voxel.y) {
        interruptionPoint();
        for (voxel.x = 0; voxel.x < dims.x; ++voxel.x) {
          if (!holds(voxel)) continue;
          low = glm::min(low, voxel);
          high = glm::max(high, voxel);
        }
      }
    const std::scoped_lock lock(mutex);
    first = glm::min(first, low);
    last = glm::max(last, high);
  });
  if (last.x < 0) return;
  low_ = first;
  size_ = last - first + 1;
  Grid box;
  box.dims = size_;
  held_.resize(box.voxelCount());
  parallelFor(static_cast<std::size_t>(size_.z), 4, [&](std::size_t begin, std::size_t end) {
    glm::ivec3 in;
    for (in.z = static_cast<int>(begin); in.z < static_cast<int>(end); ++in.z)
      for (in.y = 0; in.y < size_.y; ++in.y)
        for (in.x = 0; in.x < size_.x; ++in.x) held_[offset(in)] = holds(low_ + in) ? 1 : 0;
  });
}

std::optional<FocusVoxels::Extent> FocusVoxels::extent(const glm::dmat3& axes) const {
  if (held_.empty()) return std::nullopt;
  const glm::dmat3 toLocal = glm::transpose(axes), step = toLocal * glm::dmat3(worldFromIndex_);
  const glm::dvec3 base = toLocal * glm::dvec3(worldFromIndex_[3]);
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  Extent extent{glm::dvec3(unbounded), glm::dvec3(-unbounded)};
  std::size_t at = 0;
  glm::ivec3 in;
  for (in.z = 0; in.z < size_.z; ++in.z)
    for (in.y = 0; in.y < size_.y; ++in.y)
      for (in.x = 0; in.x < size_.x; ++in.x) {
        if (held_[at++] == 0) continue;
        const glm::dvec3 place = base + step * glm::dvec3(low_ + in);
        extent.low = glm::min(extent.low, place);
        extent.high = glm::max(extent.high, place);
      }
  return extent;
}

}  // namespace fenestra
