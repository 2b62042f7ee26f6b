#include "rendering/methods/Method.h"

namespace fenestra {

ChosenMethod Method::chosen() const {
  ChosenMethod result;
  forEachMethod([&]<class M>() {
    if (is<M>()) result = of<M>();
  });
  return result;
}

MethodStages stagesOf(const Method& method) {
  return std::visit([](const auto& chosen) { return chosen.stages(); }, method.chosen());
}

bool carves(MethodKind kind) {
  bool result = false;
  forEachMethod([&]<class M>() {
    if constexpr (requires { M::carves; }) result = result || kind == kindOf<M>;
  });
  return result;
}

}  // namespace fenestra
