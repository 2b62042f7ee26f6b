#include "rendering/scene/Scene.h"

#include <algorithm>
#include <array>
#include <mutex>

#include "rendering/scene/Parallel.h"

namespace fenestra {

bool hasCutaway(const Scene& scene) {
  return scene.look.cutaway.enabled &&
         (std::holds_alternative<LabelFocus>(scene.look.focus) || std::holds_alternative<ValueFocus>(scene.look.focus));
}

const std::shared_ptr<const Volume>& shownVolume(const Scene& scene) {
  return scene.look.hideTable && scene.tissue ? scene.tissue : scene.volume;
}

Scene shownScene(Scene scene) {
  scene.volume = shownVolume(scene);
  scene.tissue = nullptr;
  return scene;
}

Grid visibleGrid(const Volume& volume, const TransferFunction& context) {
  constexpr double visibleOpacity = 0.05;  // of 1 mm: the frame leaves haze out
  constexpr double leastShare = 0.01;      // of the fullest slab
  const Grid& grid = volume.grid;
  const std::vector<ValueGap> gaps = context.transparentGaps(visibleOpacity);
  const auto isVisible = [&](double value) {
    return std::none_of(gaps.begin(), gaps.end(),
                        [&](const ValueGap& gap) { return !(value <= gap.low || value >= gap.high); });
  };
  std::array<std::vector<std::size_t>, 3> counts;
  for (int axis = 0; axis < 3; ++axis)
    counts[static_cast<std::size_t>(axis)].resize(static_cast<std::size_t>(grid.dims[axis]));
  std::mutex mutex;
  volume.voxels.visit([&](auto scalars) {
    parallelFor(static_cast<std::size_t>(grid.dims.z), 4, [&](std::size_t begin, std::size_t end) {
      auto local = counts;
      for (auto& axis : local) std::fill(axis.begin(), axis.end(), std::size_t{0});
      // Every other row is enough to find the extent.
      for (std::size_t z = begin; z < end; ++z)
        for (int y = static_cast<int>(z % 2); y < grid.dims.y; y += 2) {
          const auto* row = scalars.data() + grid.offset({0, y, static_cast<int>(z)});
          for (int x = 0; x < grid.dims.x; ++x) {
            if (!isVisible(volume.slope * static_cast<double>(row[x]) + volume.intercept)) continue;
            ++local[0][static_cast<std::size_t>(x)];
            ++local[1][static_cast<std::size_t>(y)];
            ++local[2][z];
          }
        }
      const std::scoped_lock lock(mutex);
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < counts[axis].size(); ++i) counts[axis][i] += local[axis][i];
    });
  });
  Grid visible = grid;
  glm::ivec3 first(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<std::size_t>& slabs = counts[static_cast<std::size_t>(axis)];
    const double least = leastShare * static_cast<double>(*std::max_element(slabs.begin(), slabs.end()));
    const auto counted = [&](std::size_t count) { return count > 0 && static_cast<double>(count) >= least; };
    const auto low = std::find_if(slabs.begin(), slabs.end(), counted);
    if (low == slabs.end()) return grid;
    const auto high = std::find_if(slabs.rbegin(), slabs.rend(), counted);
    first[axis] = static_cast<int>(low - slabs.begin());
    visible.dims[axis] = static_cast<int>(slabs.rend() - high) - first[axis];
  }
  visible.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(first), 1.0));
  return visible;
}

}  // namespace fenestra
