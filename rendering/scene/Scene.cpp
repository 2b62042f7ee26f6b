#include "rendering/scene/Scene.h"

namespace fenestra {

bool hasCutaway(const Scene& scene) {
  return scene.cutaway.enabled && !std::holds_alternative<std::monostate>(scene.focus);
}

}  // namespace fenestra
