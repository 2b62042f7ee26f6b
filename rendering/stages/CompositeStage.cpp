#include "rendering/stages/CompositeStage.h"

#include <algorithm>

#include "rendering/stages/Images.h"

namespace fenestra {

CompositeStage::CompositeStage(StageList& list, const Layers& layers)
    : KeyedStage(list, Pass::Composite), layers_(layers) {
  owns(picture_);
}

CompositeKey CompositeStage::keyOf(const Frame& frame) const {
  const Look& look = frame.look();
  return {.focusLayer = layers_.seen.layer().version,
          .walls = layers_.walls.picture().version,
          .distances = layers_.starts.distances().version,
          .contextLayer = layers_.context.layer().version,
          .protectedLayer = layers_.protectedLabels.layer().version,
          .faintLayer = layers_.faint.layer().version,
          .lens = layers_.lens.surface().version,
          .ownColours = frame.hasContextLayer ? std::optional(gpu().versions().transfer) : std::nullopt,
          .method = frame.method,
          .widths = frame.widths(),
          .borderColour = look.cutaway.borderColour,
          .look = look.contextLayer,
          .leastLine = layers_.lines.leastStrength()};
}

CompositePass::Inputs CompositeStage::inputs(const Frame& frame) const {
  return {.focusLayer = below().image,
          .hitPoints = layers_.starts.hits().image,
          .distances = layers_.starts.distances().image,
          .widths = frame.widths(),
          .contextLayer = layers_.context.layer().orNull(),
          .silhouette = layers_.context.silhouette().orNull(),
          .leastLine = layers_.lines.leastStrength(),
          .editMap = layers_.starts.edits().orNull(),
          .protectedLayer = layers_.protectedLabels.layer().orNull(),
          .faintLayer = layers_.faint.layer().orNull(),
          .lensSurface = layers_.lens.surface().orNull(),
          .rayStart = frame.other ? layers_.starts.starts().orNull() : nullptr};
}

std::optional<gl::Region> CompositeStage::changedPart(const Frame& frame, const CompositeKey& key) const {
  // Strokes may open anywhere, and so bring protected labels anywhere; the line around a lens lies anywhere.
  const bool keepsRemoved = layers_.protectedLabels.layer() || layers_.faint.layer();
  if (!frame.opensNearFocus() || layers_.lens.surface() || (keepsRemoved && !frame.own.strokes->empty()))
    return std::nullopt;
  // What lies over the focus layer lies near the focus; elsewhere the picture is the focus layer.
  const auto& last = lastKey();
  return nearFocus(gpu(), frame.own, std::max(last && last->hasSameBelow(key) ? last->reach() : 0.0, key.reach()));
}

void CompositeStage::begin(const Frame& frame, Steps& steps) {
  const CompositeKey key = keyOf(frame);
  const auto part = changedPart(frame, key);
  const bool takesBelow = part && isStale(key) && !(lastKey() && lastKey()->hasSameBelow(key));
  update(frame.own, steps, key, {.part = part, .changed = changedStrokes(frame.own)}, [&](Regions regions) {
    sized(picture_, gl::Format::RGBA32F, frame.view().size, presented);
    if (takesBelow) picture_.copy(below().image);
    pass_.run(steps, gpu(), inputs(frame), frame.look(), regions, picture_);
  });
}

}  // namespace fenestra
