#include "rendering/scene/Maximum.h"

#include "rendering/settings/Look.h"

namespace fenestra {

std::optional<MethodStages::Maximum> maximumOf(const Look& look) {
  return look.cutaway.enabled ? stagesOf(look.method).maximum : std::nullopt;
}

}  // namespace fenestra
