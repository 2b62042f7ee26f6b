#include "app/WallOptions.h"

#include <algorithm>
#include <cmath>

#include "app/OptionHelpers.h"
#include "rendering/scene/Settings.h"

namespace fenestra::app {

void addWallOptions(CLI::App& command, io::StudyRequest& request) {
  addParsed(
      command, "--crosshair", "L,P,S",
      "mm, where the slices of --method walls meet, or what a lens lies over (--lens-place crosshair); a session's "
      "own, or the volume's middle otherwise, of a lens the middle of the focus",
      [&request](const std::string& text) {
        const auto point = parseNumbers<double, 3>(text, ',');
        if (!point || !std::all_of(point->begin(), point->end(), [](double mm) { return millimetres.contains(mm); }))
          return false;
        request.slices.crosshair = glm::dvec3((*point)[0], (*point)[1], (*point)[2]);
        return true;
      });
  addParsed(command, "--window", "WIDTH",
            "width of the display window of those slices; a session's or the file's own otherwise",
            [&request](const std::string& text) {
              request.windowWidth = parseNumber<double>(text);
              return request.windowWidth && *request.windowWidth > 0.0;
            });
  addParsed(command, "--level", "VALUE", "centre of that window", [&request](const std::string& text) {
    request.windowLevel = parseNumber<double>(text);
    return request.windowLevel.has_value();
  });
}

}  // namespace fenestra::app
