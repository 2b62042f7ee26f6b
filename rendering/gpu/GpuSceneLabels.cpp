// Indices of labels beside the focus: those that pictures keep, and those of each level of importance.

#include <algorithm>
#include <utility>

#include "rendering/gpu/FocusIndexing.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/scene/Importance.h"

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

}  // namespace fenestra
