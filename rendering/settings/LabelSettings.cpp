#include "rendering/settings/LabelSettings.h"

#include <algorithm>
#include <cmath>

namespace fenestra {
namespace {

auto placeOf(auto& settings, std::uint16_t label) {
  return std::lower_bound(settings.begin(), settings.end(), label,
                          [](const LabelSetting& each, std::uint16_t wanted) { return each.label < wanted; });
}

}  // namespace

LabelSetting settingFor(const LabelSettings& settings, std::uint16_t label) {
  const auto at = placeOf(settings, label);
  return at != settings.end() && at->label == label ? *at : LabelSetting{.label = label};
}

void put(LabelSettings& settings, const LabelSetting& setting) {
  const auto at = placeOf(settings, setting.label);
  const bool present = at != settings.end() && at->label == setting.label;
  if (setting == LabelSetting{.label = setting.label}) {
    if (present) settings.erase(at);
  } else if (present) {
    *at = setting;
  } else {
    settings.insert(at, setting);
  }
}

double opticalExtinction(double extinction, double opacity) {
  constexpr double thickness = 10.0;  // mm
  if (opacity >= 1.0) return extinction;
  return -std::log1p(opacity * std::expm1(-extinction * thickness)) / thickness;
}

TransferFunction atOpacity(TransferFunction function, double opacity) {
  for (TransferFunction::Node& node : function.nodes)
    node.properties.extinction = opticalExtinction(node.properties.extinction, opacity);
  return function;
}

}  // namespace fenestra
