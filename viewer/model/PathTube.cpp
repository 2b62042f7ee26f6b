#include "viewer/model/PathTube.h"

#include <algorithm>
#include <cmath>

#include "rendering/reformat/PathCurve.h"

namespace fenestra::viewer {

RegionFocus tubeAround(const std::vector<glm::dvec3>& path, double radius) {
  const reformat::PathCurve curve(path);
  // A chord of so many mm leaves a bend of 10 mm by a twentieth of a millimetre.
  constexpr double step = 2.0, most = 20'000.0;
  const int steps = static_cast<int>(std::clamp(std::ceil(curve.length() / step), 1.0, most));
  SelectionStroke stroke;
  stroke.radius = radius;
  for (int i = 0; i <= steps; ++i) stroke.anchors.push_back(curve.place(curve.length() * i / steps).point);
  RegionFocus tube;
  tube.painted.push_back(std::move(stroke));
  return tube;
}

std::optional<double> tubeRadius(const Focus& focus, const std::vector<glm::dvec3>& path) {
  const auto* region = std::get_if<RegionFocus>(&focus);
  if (path.size() < 2 || !region || !region->inside.empty() || region->painted.size() != 1) return std::nullopt;
  const SelectionStroke& stroke = region->painted.front();
  const std::vector<glm::dvec3> wanted = tubeAround(path, stroke.radius).painted.front().anchors;
  // A session may come from a machine that rounds in another way.
  constexpr double rounding = 1e-6;  // mm
  const bool isTube = stroke.adds && stroke.softness == 0.0 &&
                      std::ranges::equal(stroke.anchors, wanted, [](const glm::dvec3& a, const glm::dvec3& b) {
                        return glm::distance(a, b) < rounding;
                      });
  return isTube ? std::optional(stroke.radius) : std::nullopt;
}

}  // namespace fenestra::viewer
