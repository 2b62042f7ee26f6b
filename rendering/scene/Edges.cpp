#include "rendering/scene/Edges.h"

#include "rendering/scene/Look.h"

namespace fenestra {

bool hasSmoothEdges(const Look& look, const View& view) {
  return look.edges == Edges::Smooth && (view.quality != Quality::Draft || view.maxError);
}

}  // namespace fenestra
