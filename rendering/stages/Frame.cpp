#include "rendering/stages/Frame.h"

#include "rendering/stages/Images.h"

namespace fenestra {

std::vector<gl::Region> Sight::changedSince(const std::shared_ptr<const ProjectedStrokes>& earlier) const {
  if (earlier == strokes) return {};
  if (earlier == strokesBefore) return changed;
  return changedRegions(*earlier, *strokes, view.size, strokeMargin);
}

std::optional<gl::Region> nearFocus(const GpuScene& gpu, const Sight& sight, double reach) {
  const std::optional<IndexBox>& box = gpu.openedBox();
  return box ? std::optional(sight.rays.around(*box, reach)) : std::nullopt;
}

gl::Region nearVolume(const GpuScene& gpu, const Frame& frame, double reach) {
  const IndexBox all{glm::ivec3(0), gpu.grid().dims - 1};
  gl::Region seen = frame.own.rays.around(all, reach);
  if (frame.exploded)
    for (const FocusLayerPass::ExplodedStretch& stretch : frame.exploded->stretches)
      seen = around(seen, stretch.rays.around(all, reach));
  return seen;
}

}  // namespace fenestra
