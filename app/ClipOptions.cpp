#include "app/ClipOptions.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/options/Numbers.h"

namespace fenestra::app {
namespace {

/// "LOW:HIGH", either of which may be missing.
std::optional<std::array<std::optional<double>, 2>> endsIn(const std::string& text) {
  const std::vector<std::string> parts = io::split(text, ':');
  if (parts.size() != 2) return std::nullopt;
  std::array<std::optional<double>, 2> ends;
  for (std::size_t side = 0; side < 2; ++side) {
    if (parts[side].empty()) continue;
    ends[side] = parseNumber<double>(parts[side]);
    if (!ends[side]) return std::nullopt;
  }
  return ends;
}

std::optional<io::ClipChanges::Ends> cropIn(const std::string& text) {
  const std::vector<std::string> parts = io::split(text, ',');
  if (parts.size() != 3) return std::nullopt;
  io::ClipChanges::Ends ends;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto pair = endsIn(parts[axis]);
    if (!pair) return std::nullopt;
    ends[axis] = *pair;
    if ((*pair)[0] && (*pair)[1] && !(*(*pair)[0] < *(*pair)[1]))
      throw WrongValue{"\"" + parts[axis] + "\" holds nothing: give the lower end first"};
  }
  return ends;
}

/// "NX,NY,NZ,D", or "X,Y,Z,NX,NY,NZ" of a point on the plane and the normal.
std::optional<HalfSpace> planeIn(const std::string& text) {
  glm::dvec3 normal;
  double offset = 0.0;
  if (const auto four = parseNumbers<double, 4>(text, ',')) {
    normal = {(*four)[0], (*four)[1], (*four)[2]};
    offset = (*four)[3];
  } else if (const auto six = parseNumbers<double, 6>(text, ',')) {
    normal = {(*six)[3], (*six)[4], (*six)[5]};
  } else {
    return std::nullopt;
  }
  const double length = glm::length(normal);
  if (!(length > 1e-12) || !std::isfinite(length)) throw WrongValue{"\"" + text + "\" has a normal of no length"};
  normal /= length;
  if (const auto six = parseNumbers<double, 6>(text, ','))
    offset = glm::dot(normal, glm::dvec3((*six)[0], (*six)[1], (*six)[2]));
  return HalfSpace{normal, offset};
}

void addPlanes(Command command, Clipping& clipping) {
  const std::string form = "NX,NY,NZ,D|X,Y,Z,NX,NY,NZ|none";
  command.addRepeated(
      "--clip-plane", form,
      "show only what lies before a plane: where NX·L + NY·P + NZ·S is at least D, mm along the normal, or on the "
      "side that the normal at the point X,Y,Z (LPS, mm) shows to. Up to three times; none: not even a session's",
      [form, &clipping](const std::vector<std::string>& texts) {
        clipping.planes.clear();
        for (const std::string& text : texts) {
          if (text == "none") continue;
          const auto plane = planeIn(text);
          if (!plane) throw WrongValue{"\"" + text + "\" is not " + form};
          clipping.planes.push_back(*plane);
        }
        if (clipping.planes.size() > Clipping::mostPlanes) throw WrongValue{"is given more than three times"};
      });
}

}  // namespace

void addClipping(Command command, io::ClipChanges& changes, Clipping& clipping) {
  command.add(
      "--crop", "L0:L1,P0:P1,S0:S1|none",
      "show only the inside of a box: mm (LPS) along the volume's own axes nearest to L, P and S; a missing end is "
      "the volume's. none: not even a session's",
      [&](const std::string& text) {
        changes.crop.reset();
        clipping.cropped = false;
        if (text == "none") return true;
        changes.crop = cropIn(text);
        return changes.crop.has_value();
      });
  addPlanes(command, clipping);
  command.add("--clip-exempt", "LABEL,...|none", "labels, by value or name, that are never clipped",
              [&](const std::string& text) {
                clipping.exempt.clear();
                changes.exempt = text == "none" ? std::vector<std::string>() : io::split(text, ',');
                return std::none_of(changes.exempt.begin(), changes.exempt.end(),
                                    [](const std::string& label) { return label.empty(); });
              });
  command.add(
      "--clip-grey", "WIDTH,LEVEL|none",
      "show values on the clipped faces in grey with this window, opaque, as slices do; default as the transfer "
      "function shows them",
      [&clipping](const std::string& text) {
        clipping.grey.reset();
        if (text == "none") return true;
        const auto window = parseNumbers<double, 2>(text, ',');
        if (!window || !((*window)[0] > 0.0)) return false;
        clipping.grey = WindowLevel{(*window)[0], (*window)[1]};
        return true;
      });
}

}  // namespace fenestra::app
