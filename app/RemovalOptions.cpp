#include "app/RemovalOptions.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/options/Numbers.h"
#include "rendering/scene/RemovedVoxels.h"
#include "rendering/settings/SettingWords.h"

namespace fenestra::app {
namespace {

using Parts = std::vector<std::string>;

/// "L,P,S;L,P,S;..."
std::optional<std::vector<glm::dvec3>> pointsIn(const std::string& text) {
  std::vector<glm::dvec3> points;
  for (const std::string& each : io::split(text, ';')) {
    const auto point = parseVector(each);
    if (!point) return std::nullopt;
    points.push_back(*point);
  }
  return points;
}

/// The number at a place that may be missing, from 0; false where there is something else.
bool takeNumber(const Parts& parts, std::size_t at, double& target) {
  if (at >= parts.size()) return true;
  const auto number = parseNumber<double>(parts[at]);
  if (!number || *number < 0.0) return false;
  target = *number;
  return true;
}

bool takePoints(const std::string& text, Removal& removal) {
  auto points = pointsIn(text);
  if (points) removal.points = std::move(*points);
  return points.has_value();
}

bool takeVector(const Parts& parts, std::size_t at, glm::dvec3& target) {
  if (at >= parts.size()) return true;
  const auto vector = parseVector(parts[at]);
  if (vector) target = *vector;
  return vector.has_value();
}

/// What stands behind the word of the shape.
bool takeCarving(const Parts& parts, Removal& removal) {
  switch (removal.shape) {
    case RemovalShape::Ball:
      return parts.size() >= 3 && parts.size() <= 4 && takePoints(parts[1], removal) &&
             takeNumber(parts, 2, removal.size) && takeNumber(parts, 3, removal.softness);
    case RemovalShape::Box:
      return (parts.size() == 3 || parts.size() == 4 || parts.size() == 6) && takePoints(parts[1], removal) &&
             takeVector(parts, 2, removal.sides) && takeNumber(parts, 3, removal.softness) &&
             takeVector(parts, 4, removal.direction) && takeVector(parts, 5, removal.up);
    case RemovalShape::Saw:
      return parts.size() >= 5 && parts.size() <= 6 && takePoints(parts[1], removal) &&
             takeVector(parts, 2, removal.direction) && takeNumber(parts, 3, removal.depth) &&
             takeNumber(parts, 4, removal.size) && takeNumber(parts, 5, removal.softness);
    case RemovalShape::Plane:
      break;
  }
  return false;
}

std::optional<Removal> carvingIn(const std::string& text) {
  const Parts parts = io::split(text, ':');
  for (const Word<RemovalShape>& each : wordsOf(RemovalShape{})) {
    if (parts.empty() || parts[0] != each.word) continue;
    Removal removal;
    removal.shape = each.value;
    if (takeCarving(parts, removal)) return removal;
  }
  return std::nullopt;
}

/// "L,P,S,MM,RADIUS" of a drag.
std::optional<Bend> bendIn(const std::string& text) {
  const auto numbers = parseNumbers<double, 5>(text, ',');
  if (!numbers) return std::nullopt;
  return Bend{{(*numbers)[0], (*numbers)[1], (*numbers)[2]}, (*numbers)[3], (*numbers)[4]};
}

std::optional<Removal> bentPlaneIn(const std::string& text) {
  constexpr std::string_view dragged = "drag=";
  Parts parts = io::split(text, ':');
  Removal removal;
  removal.shape = RemovalShape::Plane;
  while (!parts.empty() && parts.back().starts_with(dragged)) {
    const auto bend = bendIn(parts.back().substr(dragged.size()));
    if (!bend) return std::nullopt;
    removal.bends.insert(removal.bends.begin(), *bend);
    parts.pop_back();
  }
  const bool isPlane = parts.size() >= 2 && parts.size() <= 5 && takePoints(parts[0], removal) &&
                       takeVector(parts, 1, removal.direction) && takeNumber(parts, 2, removal.depth) &&
                       takeNumber(parts, 3, removal.extent) && takeNumber(parts, 4, removal.softness);
  return isPlane ? std::optional(removal) : std::nullopt;
}

/// An option that may be given several times; `owns` says which removals are of its kind.
template <class Parse, class Owns>
void addKind(Command command, Removals& removals, const std::string& name, const std::string& form,
             const std::string& description, Parse parse, Owns owns) {
  command.addRepeated(name, form, description, [=, &removals](const std::vector<std::string>& texts) {
    std::erase_if(removals, owns);
    for (const std::string& text : texts) {
      if (text == "none") continue;
      const std::optional<Removal> removal = parse(text);
      if (!removal) throw WrongValue{"\"" + text + "\" is not " + form};
      if (!removesAnything(*removal))
        throw WrongValue{"\"" + text +
                         "\" removes nothing: its lengths must be above 0, and its directions have a length and lie "
                         "apart"};
      removals.push_back(*removal);
    }
  });
}

}  // namespace

void addRemovals(Command command, Removals& removals) {
  const auto isPlane = [](const Removal& removal) { return removal.shape == RemovalShape::Plane; };
  addKind(
      command, removals, "--carve",
      "ball:POINTS:RADIUS[:SOFT]|box:POINTS:SIDES[:SOFT[:FORWARD:UP]]|"
      "saw:POINTS:DIRECTION:DEPTH:WIDTH[:SOFT]|none",
      "remove a ball along the lines between POINTS (L,P,S;L,P,S;...), a box at each of them, or what a saw cuts along "
      "them; where its last point is the first, it takes out what they enclose, too. All in mm, LPS; SIDES are A,B,C "
      "across, along UP and along FORWARD; DEPTH 0 has no end; SOFT is the width of the rim. Can be given several "
      "times; none: not even a session's",
      carvingIn, [isPlane](const Removal& removal) { return !isPlane(removal); });
  addKind(
      command, removals, "--bend", "POINTS:TOWARDS[:DEPTH[:EXTENT[:SOFT]]][:drag=L,P,S,MM,RADIUS]...|none",
      "remove what lies on the side TOWARDS (a direction, L,P,S) of a plane through POINTS (L,P,S;L,P,S;...) by their "
      "principal axes, down to DEPTH mm and EXTENT mm to each side; 0 has no end. Each drag bends the plane by MM at a "
      "point, within a sphere. Can be given several times; none: not even a session's",
      bentPlaneIn, isPlane);
}

}  // namespace fenestra::app
