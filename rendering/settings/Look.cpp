#include "rendering/settings/Look.h"

namespace fenestra {

TransferFunction ContextFunction::shifted() const {
  TransferFunction result = function;
  for (TransferFunction::Node& node : result.nodes) node.value += shift;
  return result;
}

glm::dvec3 backgroundRise(const Look& look) {
  return look.backdrop == Backdrop::Gradient ? look.backgroundTop - look.background : glm::dvec3(0.0);
}

glm::dvec3 backgroundAt(const Look& look, double height) { return look.background + height * backgroundRise(look); }

}  // namespace fenestra
