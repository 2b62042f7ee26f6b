#include "rendering/scene/Edges.h"

#include "rendering/scene/Maximum.h"
#include "rendering/scene/Walls.h"

namespace fenestra {

bool hasSmoothEdges(const Look& look, const View& view) {
  const MethodStages method = stagesOf(look.method);
  const bool opens = look.cutaway.enabled && !std::holds_alternative<std::monostate>(look.focus) &&
                     method.start != MethodStages::Start::Entry;
  return look.edges == Edges::Smooth && !(opens && !method.opensBetweenPixels()) && !wallsOf(look) &&
         !maximumOf(look) && (view.quality != Quality::Draft || view.maxError);
}

}  // namespace fenestra
