#pragma once
// The option for ready-made light.

#include <algorithm>
#include <string>

#include "app/OptionHelpers.h"
#include "rendering/scene/Lighting.h"

namespace fenestra::app {

/// To be added before the options of the light itself, which override it then.
inline void addLightPreset(CLI::App& command, Shading& shading) {
  std::string names;
  for (const LightPreset& each : lightPresets()) names += (names.empty() ? "" : "|") + std::string(each.id);
  addParsed(command, "--light-preset", names, "light ready made, from wherever it comes; default standard",
            [&shading](const std::string& text) {
              const auto all = lightPresets();
              const auto chosen =
                  std::find_if(all.begin(), all.end(), [&](const LightPreset& each) { return each.id == text; });
              if (chosen == all.end()) return false;
              chosen->applyTo(shading);
              return true;
            });
}

}  // namespace fenestra::app
