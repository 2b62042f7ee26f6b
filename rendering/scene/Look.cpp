#include "rendering/scene/Look.h"

namespace fenestra {

TransferFunction ContextFunction::shifted() const {
  TransferFunction result = function;
  for (TransferFunction::Node& node : result.nodes) node.value += shift;
  return result;
}

}  // namespace fenestra
