// reformat: a volume straightened along a path, or cut across it.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/Commands.h"
#include "app/cli/PathFile.h"
#include "app/cli/Report.h"
#include "app/cli/SliceFile.h"
#include "io/study/ReadStudy.h"
#include "rendering/reformat/CentreLine.h"
#include "rendering/reformat/Straighten.h"

namespace fenestra::cli {
namespace {

using Json = nlohmann::ordered_json;
using namespace reformat;

/// The region in focus; empty without one.
VoxelRegion regionInFocus(const io::Study& study) {
  const Scene& scene = study.drawn.scene();
  const auto* labels = std::get_if<LabelFocus>(&scene.look.focus);
  if (!labels || !scene.labels) return {};
  return regionOf(*scene.labels, labels->labels);
}

/// The path of the file, or else the centre line of the focus.
std::vector<glm::dvec3> pathOf(const ReformatOptions& options, const VoxelRegion& region) {
  if (!options.path.empty()) return readPath(options.path);
  if (region.isEmpty())
    throw io::Error(options.study.source(), "has no path to follow",
                    "name a file of points by --path, or a tubular structure by --focus-labels or --seed");
  std::vector<glm::dvec3> points = centreLineOf(region).points;
  if (points.empty())
    throw io::Error(options.study.source(), "the structure in focus is no tube: it is hardly longer than thick",
                    "name a vessel or another tube by --focus-labels, or a file of points by --path");
  return points;
}

/// What is known of the places along the curve, about a millimetre apart, at most a thousand of them.
Json placesAlong(const PathCurve& curve, const VoxelRegion& region) {
  const int steps = std::clamp(static_cast<int>(std::ceil(curve.length())), 1, 1000);
  Json places = Json::array();
  for (int i = 0; i <= steps; ++i) {
    const double mm = curve.length() * i / steps;
    const PathPlace place = curve.place(mm);
    Json json{{"at", mm}, {"point", listOf(place.point)}};
    if (!region.isEmpty()) {
      // A clicked path need not run in the middle.
      constexpr double reach = 2.0;
      const std::optional<Section> section = sectionOf(region, place, reach);
      json["area"] = section ? Json(section->area) : Json(nullptr);
      json["radius"] = section ? Json(section->radius()) : Json(nullptr);
    }
    places.push_back(std::move(json));
  }
  return places;
}

void requireSize(const ReformatOptions& options, double mm, double spacing) {
  if (mm / spacing < largestStraightPicture) return;
  throw io::Error(options.study.source(),
                  "the picture would have more than " + std::to_string(largestStraightPicture) + " pixels a side",
                  "name larger pixels by --spacing");
}

double finestSpacing(const Grid& grid) { return std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}); }

}  // namespace

void reformat(const ReformatOptions& options) {
  const io::Study study = io::readStudy(options.study, progressOnTerminal());
  printWarnings(study.warnings);
  const Volume& volume = *study.scene.volume;
  const VoxelRegion region = regionInFocus(study);
  const PathCurve curve(pathOf(options, region));
  const double spacing = options.spacing.value_or(finestSpacing(volume.grid));
  const double angle = glm::radians(options.angle);
  requireSize(options, std::max(curve.length(), options.width), spacing);

  SliceGeometry geometry;
  std::vector<float> values;
  if (options.section) {
    if (*options.section < 0.0 || *options.section > curve.length())
      throw io::Error(options.study.source(), "the path has no place at " + std::to_string(*options.section) + " mm",
                      "its length is " + std::to_string(curve.length()) + " mm");
    geometry = crossSection(curve, *options.section, spacing, options.width, angle);
    values = sliceValues(volume, geometry, 0);
  } else {
    StraightPicture picture = straightened(volume, curve, spacing, options.width, angle);
    // A straightened picture has no place in the patient.
    geometry.width = picture.width;
    geometry.height = picture.height;
    geometry.right = {spacing, 0.0, 0.0};
    geometry.down = {0.0, spacing, 0.0};
    geometry.normal = {0.0, 0.0, spacing};
    values = std::move(picture.values);
  }
  WindowLevel window = volume.defaultWindow();
  window.width = options.windowWidth.value_or(window.width);
  window.level = options.level.value_or(window.level);
  if (isValueFile(options.output))
    writeValues(options.output, geometry, 0, values);
  else
    writeGrey(options.output, {geometry.width, geometry.height}, values, window, volume.lowIsWhite);

  Json json{{"path", options.path.empty() ? "centre line" : options.path.string()},
            {"length", curve.length()},
            {"size", {geometry.width, geometry.height}},
            {"spacing", spacing},
            {"angle", options.angle},
            {"interpolation", "trilinear"}};
  if (options.section) {
    json["section"] = *options.section;
    json["centre"] = listOf(curve.place(*options.section).point);
    json["right"] = listOf(glm::normalize(geometry.right));
    json["down"] = listOf(glm::normalize(geometry.down));
    json["normal"] = listOf(glm::normalize(geometry.normal));
  }
  json["places"] = placesAlong(curve, region);
  printJson(json);
}

}  // namespace fenestra::cli
