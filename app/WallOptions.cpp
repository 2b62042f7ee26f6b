#include "app/WallOptions.h"

#include <algorithm>
#include <cmath>

#include "app/OptionHelpers.h"
#include "rendering/scene/Settings.h"

namespace fenestra::app {

void addWallOptions(CLI::App& command, SceneOptions& options) {
  addParsed(
      command, "--crosshair", "L,P,S",
      "mm, where the slices of --method walls meet, or what a lens lies over (--lens-place crosshair); a session's "
      "own, or the volume's middle otherwise, of a lens the middle of the focus",
      [&options](const std::string& text) {
        const auto point = parseNumbers<double, 3>(text, ',');
        if (!point || !std::all_of(point->begin(), point->end(), [](double mm) { return millimetres.contains(mm); }))
          return false;
        options.slices.crosshair = glm::dvec3((*point)[0], (*point)[1], (*point)[2]);
        return true;
      });
  addParsed(command, "--window", "WIDTH",
            "width of the display window of those slices; a session's or the file's own otherwise",
            [&options](const std::string& text) {
              options.windowWidth = parseNumber<double>(text);
              return options.windowWidth && *options.windowWidth > 0.0;
            });
  addParsed(command, "--level", "VALUE", "centre of that window", [&options](const std::string& text) {
    options.windowLevel = parseNumber<double>(text);
    return options.windowLevel.has_value();
  });
}

ShownSlices slicesOf(const SceneOptions& options, const Volume& volume) {
  ShownSlices slices = options.slices;
  if (!options.windowWidth && !options.windowLevel) return slices;
  WindowLevel window = slices.window ? *slices.window : volume.defaultWindow();
  window.width = options.windowWidth.value_or(window.width);
  window.level = options.windowLevel.value_or(window.level);
  slices.window = window;
  return slices;
}

}  // namespace fenestra::app
