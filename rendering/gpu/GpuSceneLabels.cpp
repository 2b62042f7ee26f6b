// Indices of labels: which of the focus share a material, those that pictures keep, and those of each level of
// importance.

#include <algorithm>
#include <utility>

#include "rendering/gpu/FocusIndexing.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/scene/Importance.h"
#include "rendering/volume/Threads.h"

namespace fenestra {

void GpuScene::updateKeptLabels(const Scene& scene, bool volumeChanged) {
  if (volumeChanged) protected_.map = exempt_.map = nullptr;
  std::vector<std::uint16_t> guarded, exempt;
  if (hasCutaway(scene)) guarded = labelsWith(LabelRole::Protected, scene);
  const Clipping& clipping = scene.look.clipping;
  if (!clipping.exempt.empty() && !halfSpaces(clipping, grid()).empty()) exempt = clipping.exempt;
  updateKept(protected_, std::move(guarded), LabelSmoothing::Off, scene, versions_.protectedLabels);
  updateKept(exempt_, std::move(exempt), LabelSmoothing::Off, scene, versions_.exemptLabels);
  for (KeptLabels* kept : {&protected_, &exempt_})
    kept->faint.update(kept->any() ? faintLabels_ : FaintLabels(), kept->map, kept->labels);

  std::vector<std::vector<std::uint16_t>> levels = importanceLevels(scene);
  if (levels.size() != importance_.size()) {
    importance_.clear();
    importance_.resize(levels.size());
    ++versions_.importance;
  }
  for (std::size_t i = 0; i < levels.size(); ++i)
    updateKept(importance_[i], std::move(levels[i]), scene.look.labelSmoothing, scene, versions_.importance);
}

void GpuScene::updateKept(KeptLabels& kept, std::vector<std::uint16_t> wanted, LabelSmoothing smoothing,
                          const Scene& scene, std::uint64_t& version) {
  const std::shared_ptr<const LabelMap> map = wanted.empty() ? nullptr : structuresOf(scene);
  if (wanted == kept.labels && map == kept.map && smoothing == kept.smoothing) return;
  kept = {};
  kept.labels = std::move(wanted);
  kept.map = map;
  kept.smoothing = smoothing;
  ++version;
  if (!map) return;
  Scene held{scene.volume, map, {}};
  held.look.focus = LabelFocus{kept.labels};
  held.look.labelSmoothing = smoothing;
  const FocusIndex index = buildFocusIndex(held, refinement_ > 1 ? voxelBricks_ : bricks_);
  kept.box = index.box;
  if (!index.box) return;
  kept.smoothed = index.smoothed != nullptr;
  kept.bricks = gl::Texture::make3D(gl::Format::R32UI, index.bricks);
  kept.bricks.upload(std::span<const std::uint32_t>(index.slots));
  kept.skip = gl::Texture::make3D(gl::Format::R16UI, bricks_.dims);
  kept.skip.upload(std::span<const std::uint16_t>(skipTexels(bricks_.dims, drawnOccupied(index))));
  std::vector<std::uint32_t> smoothed;
  if (kept.smoothed) smoothed = index.smoothedCells();
  kept.cells = gl::Buffer(std::as_bytes(std::span(kept.smoothed ? smoothed : index.cells)));
}

void GpuScene::makePaletteIndex(const LabelMap& labels, const std::vector<std::uint8_t>& entryOf) {
  // The 0.5 level reaches at most half a voxel past the labelled ones: a margin of one takes its neighbour's entry.
  focusOrigin_ = glm::max(focus_.index().box->low - 1, 0);
  const glm::ivec3 size = glm::min(focus_.index().box->high + 1, labels.grid.dims - 1) - focusOrigin_ + 1;
  std::vector<std::uint8_t> entries(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                                    static_cast<std::size_t>(size.z));
  labels.voxels.visit([&](auto values) {
    if constexpr (std::is_unsigned_v<typename decltype(values)::value_type>) {
      const auto entryAt = [&](glm::ivec3 voxel) -> std::uint8_t {
        return labels.grid.contains(voxel) ? entryOf[static_cast<std::uint16_t>(values[labels.grid.offset(voxel)])] : 0;
      };
      parallelFor(static_cast<std::size_t>(size.z), 4, [&](std::size_t begin, std::size_t end) {
        for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
          for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
              const glm::ivec3 voxel = focusOrigin_ + glm::ivec3(x, y, z);
              std::uint8_t entry = entryAt(voxel);
              for (int n = 0; entry == 0 && n < 27; ++n)
                entry = entryAt(voxel + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1);
              entries[static_cast<std::size_t>(x) +
                      static_cast<std::size_t>(size.x) *
                          (static_cast<std::size_t>(y) +
                           static_cast<std::size_t>(size.y) * static_cast<std::size_t>(z))] = entry;
            }
      });
    }
  });
  focusPaletteIndex_ = gl::Texture::make3D(gl::Format::R8UI, size);
  focusPaletteIndex_.upload(std::span<const std::uint8_t>(entries));
}

}  // namespace fenestra
