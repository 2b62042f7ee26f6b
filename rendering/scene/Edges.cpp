#include "rendering/scene/Edges.h"

#include "rendering/scene/Walls.h"

namespace fenestra {

bool opensBetweenPixels(MethodKind kind) { return kind == MethodKind::Adaptive || kind == MethodKind::Selection; }

bool hasSmoothEdges(const Look& look, const View& view) {
  const bool opens = look.cutaway.enabled && !std::holds_alternative<std::monostate>(look.focus) &&
                     stagesOf(look.method).start != MethodStages::Start::Entry;
  return look.edges == Edges::Smooth && !(opens && !opensBetweenPixels(look.method.kind)) && !wallsOf(look) &&
         (view.quality != Quality::Draft || view.maxError);
}

}  // namespace fenestra
