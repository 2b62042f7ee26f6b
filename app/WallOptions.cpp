#include "app/WallOptions.h"

#include <optional>
#include <string>

#include "app/options/Numbers.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra::app {

void addWallOptions(Command command, io::StudyRequest& request) {
  command.add(
      "--crosshair", "L,P,S",
      "mm, where the slices of --method walls meet, or what a lens lies over (--lens-place crosshair); a session's "
      "own, or the volume's middle otherwise, of a lens the middle of the focus",
      [&request](const std::string& text) {
        const std::optional<glm::dvec3> point = parseVector(text);
        for (int axis = 0; point && axis < 3; ++axis)
          if (!millimetres.contains((*point)[axis])) return false;
        if (point) request.slices.crosshair = point;
        return point.has_value();
      });
  command.add("--window", "WIDTH",
              "width of the display window of those slices; a session's or the file's own otherwise",
              [&request](const std::string& text) {
                request.windowWidth = parseNumber<double>(text);
                return request.windowWidth && *request.windowWidth > 0.0;
              });
  command.add("--level", "VALUE", "centre of that window", [&request](const std::string& text) {
    request.windowLevel = parseNumber<double>(text);
    return request.windowLevel.has_value();
  });
}

}  // namespace fenestra::app
