#include "io/PhantomFile.h"

#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "fenestra/resources.h"

namespace fenestra::io {
namespace {

using Json = nlohmann::json;

constexpr std::string_view folder = "phantoms/", ending = ".json";

/// Reads one description; every complaint names the body it is about.
class Parser {
 public:
  explicit Parser(std::string source) : source_(std::move(source)) {}

  Phantom parse(std::string_view text) {
    Json root;
    try {
      root = Json::parse(text);
    } catch (const Json::parse_error& error) {
      fail("is not JSON (byte " + std::to_string(error.byte) + ")");
    } catch (const Json::out_of_range&) {
      fail("holds a number too large for double precision");
    }
    checkKeys(root, {"name", "extent", "background", "bodies"});
    Phantom phantom;
    phantom.name = string(root, "name");
    phantom.extent = vector(root, "extent");
    if (!(glm::min(phantom.extent.x, glm::min(phantom.extent.y, phantom.extent.z)) > 0.0))
      fail("\"extent\" must be positive");
    phantom.background = number(root, "background");
    const Json& bodies = member(root, "bodies");
    if (!bodies.is_array() || bodies.empty()) fail("\"bodies\" must be a list of at least one body");
    for (const Json& body : bodies) phantom.bodies.push_back(parseBody(body, phantom.bodies));
    return phantom;
  }

 private:
  [[noreturn]] void fail(const std::string& cause) const {
    throw Error(source_, body_.empty() ? cause : "body \"" + body_ + "\": " + cause,
                "the phantoms in resources/phantoms show the format");
  }

  void checkKeys(const Json& object, std::initializer_list<std::string_view> known) const {
    if (!object.is_object()) fail("an object in braces is expected");
    for (const auto& item : object.items())
      if (std::find(known.begin(), known.end(), item.key()) == known.end()) fail("unknown key \"" + item.key() + "\"");
  }

  const Json& member(const Json& object, const char* key) const {
    const auto at = object.find(key);
    if (at == object.end()) fail(std::string("\"") + key + "\" is missing");
    return *at;
  }

  double toNumber(const Json& value, const char* key) const {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      fail(std::string("\"") + key + "\" must be a number");
    return value.get<double>();
  }
  double number(const Json& object, const char* key) const { return toNumber(member(object, key), key); }
  double positive(const Json& object, const char* key) const {
    const double value = number(object, key);
    if (!(value > 0.0)) fail(std::string("\"") + key + "\" must be positive");
    return value;
  }
  std::string string(const Json& object, const char* key) const {
    const Json& value = member(object, key);
    if (!value.is_string()) fail(std::string("\"") + key + "\" must be a text");
    return value.get<std::string>();
  }
  glm::dvec3 toVector(const Json& value, const char* key) const {
    if (!value.is_array() || value.size() != 3) fail(std::string("\"") + key + "\" must be three numbers");
    return {toNumber(value[0], key), toNumber(value[1], key), toNumber(value[2], key)};
  }
  glm::dvec3 vector(const Json& object, const char* key) const { return toVector(member(object, key), key); }

  /// "rotation": degrees about the world's x, then y, then z axis.
  glm::dmat3 rotation(const Json& object) const {
    if (!object.contains("rotation")) return glm::dmat3(1.0);
    const glm::dvec3 angles = glm::radians(vector(object, "rotation"));
    glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angles.z, {0.0, 0.0, 1.0});
    turn = glm::rotate(turn, angles.y, {0.0, 1.0, 0.0});
    return glm::dmat3(glm::rotate(turn, angles.x, {1.0, 0.0, 0.0}));
  }

  template <class Solid>
  Solid solid(const Json& shape) const {
    checkKeys(shape, {"type", "centre", "semiAxes", "rotation", "mirror"});
    const glm::dvec3 semiAxes = vector(shape, "semiAxes");
    if (!(semiAxes.x > 0.0 && semiAxes.y > 0.0 && semiAxes.z > 0.0)) fail("\"semiAxes\" must be positive");
    return {vector(shape, "centre"), semiAxes, rotation(shape)};
  }

  static void appendChain(const std::vector<glm::dvec3>& points, double radius, std::vector<Shape>& shapes) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) shapes.push_back(Capsule{points[i], points[i + 1], radius});
  }

  /// Capsules through "points".
  void parseChain(const Json& shape, std::vector<Shape>& shapes) const {
    checkKeys(shape, {"type", "points", "radius", "mirror"});
    const Json& list = member(shape, "points");
    if (!list.is_array() || list.size() < 2) fail("\"points\" must be a list of at least two points");
    std::vector<glm::dvec3> points;
    for (const Json& point : list) points.push_back(toVector(point, "points"));
    appendChain(points, positive(shape, "radius"), shapes);
  }

  /// Capsules along centre + u·cos φ + v·sin φ, φ from "from" to "to" degrees in "steps" pieces: a rib, a vessel's
  /// bend.
  void parseArc(const Json& shape, std::vector<Shape>& shapes) const {
    checkKeys(shape, {"type", "centre", "u", "v", "from", "to", "steps", "radius", "mirror"});
    const glm::dvec3 centre = vector(shape, "centre"), u = vector(shape, "u"), v = vector(shape, "v");
    const double from = glm::radians(number(shape, "from")), to = glm::radians(number(shape, "to"));
    const double steps = number(shape, "steps");
    if (!(steps >= 1.0 && steps <= 1000.0) || steps != std::floor(steps))
      fail("\"steps\" must be a whole number from 1 to 1000");
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
      const double angle = from + (to - from) * i / steps;
      points.push_back(centre + u * std::cos(angle) + v * std::sin(angle));
    }
    appendChain(points, positive(shape, "radius"), shapes);
  }

  /// `shape` on the other side of the body's midplane x = 0.
  static Shape mirrored(const Shape& shape) {
    const glm::dvec3 flip(-1.0, 1.0, 1.0);
    const auto flipSolid = [&](auto solid) {
      solid.centre *= flip;
      for (int axis = 0; axis < 3; ++axis) solid.axes[axis] *= flip;
      return solid;
    };
    if (const auto* capsule = std::get_if<Capsule>(&shape))
      return Capsule{capsule->a * flip, capsule->b * flip, capsule->radius};
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape)) return flipSolid(*ellipsoid);
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return flipSolid(*cylinder);
    return flipSolid(std::get<Box>(shape));
  }

  void parseShape(const Json& shape, std::vector<Shape>& shapes) const {
    if (!shape.is_object()) fail("a shape must be an object in braces");
    const std::size_t first = shapes.size();
    const std::string type = string(shape, "type");
    if (type == "ellipsoid") {
      shapes.push_back(solid<Ellipsoid>(shape));
    } else if (type == "cylinder") {
      shapes.push_back(solid<Cylinder>(shape));
    } else if (type == "box") {
      shapes.push_back(solid<Box>(shape));
    } else if (type == "chain") {
      parseChain(shape, shapes);
    } else if (type == "arc") {
      parseArc(shape, shapes);
    } else {
      fail("unknown shape \"" + type + "\" (known: ellipsoid, cylinder, box, chain, arc)");
    }
    if (!shape.contains("mirror")) return;
    if (!shape["mirror"].is_boolean()) fail("\"mirror\" must be true or false");
    if (!shape["mirror"].get<bool>()) return;
    const std::size_t last = shapes.size();
    for (std::size_t i = first; i < last; ++i) shapes.push_back(mirrored(shapes[i]));
  }

  /// The shapes of an earlier body, thinner by "by" mm all around: the next layer inwards.
  void parseInset(const Json& inset, const std::vector<PhantomBody>& earlier, std::vector<Shape>& shapes) const {
    checkKeys(inset, {"of", "by"});
    const std::string name = string(inset, "of");
    const double by = number(inset, "by");
    const auto body =
        std::find_if(earlier.begin(), earlier.end(), [&](const PhantomBody& b) { return b.name == name; });
    if (body == earlier.end()) fail("\"inset\" names no earlier body: \"" + name + "\"");
    for (Shape shape : body->shapes) {
      const double thinnest = std::visit(
          [&](auto& s) {
            if constexpr (std::is_same_v<std::decay_t<decltype(s)>, Capsule>) {
              return s.radius -= by;
            } else {
              s.semiAxes -= by;
              return std::min({s.semiAxes.x, s.semiAxes.y, s.semiAxes.z});
            }
          },
          shape);
      if (!(thinnest > 0.0)) fail("\"inset\" leaves nothing of a shape of \"" + name + "\"");
      shapes.push_back(shape);
    }
  }

  PhantomBody parseBody(const Json& object, const std::vector<PhantomBody>& earlier) {
    body_ = "number " + std::to_string(earlier.size() + 1);
    checkKeys(object, {"name", "label", "value", "colour", "shapes", "inset"});
    PhantomBody body;
    body.name = body_ = string(object, "name");
    const double label = number(object, "label");
    if (!(label >= 0.0 && label <= std::numeric_limits<std::uint16_t>::max()) || label != std::floor(label))
      fail("\"label\" must be a whole number from 0 to 65535");
    body.label = static_cast<std::uint16_t>(label);
    body.value = number(object, "value");
    body.colour = vector(object, "colour");
    if (glm::any(glm::lessThan(body.colour, glm::dvec3(0.0))) ||
        glm::any(glm::greaterThan(body.colour, glm::dvec3(1.0))))
      fail("\"colour\" must be three numbers from 0 to 1");
    if (object.contains("inset")) parseInset(object["inset"], earlier, body.shapes);
    if (object.contains("shapes")) {
      if (!object["shapes"].is_array()) fail("\"shapes\" must be a list");
      for (const Json& shape : object["shapes"]) parseShape(shape, body.shapes);
    }
    if (body.shapes.empty()) fail("has no shapes");
    body_.clear();
    return body;
  }

  std::string source_;
  std::string body_;  ///< the body being read, for messages
};

}  // namespace

std::vector<std::string> phantomNames() {
  std::vector<std::string> names;
  for (std::string_view path : resources::paths())
    if (path.starts_with(folder) && path.ends_with(ending))
      names.emplace_back(path.substr(folder.size(), path.size() - folder.size() - ending.size()));
  return names;
}

Phantom loadPhantom(const std::string& name) {
  const std::string path = std::string(folder) + name + std::string(ending);
  const std::string_view text = resources::find(path);
  if (text.empty()) {
    std::string known;
    for (const std::string& other : phantomNames()) known += (known.empty() ? "" : ", ") + other;
    throw Error(name, "there is no such phantom", "the built-in phantoms are: " + known);
  }
  return parsePhantom(text, path);
}

OpenedPhantom openPhantom(const std::string& name, int voxels, const Progress& progress) {
  if (progress && !progress(0.0, "making the phantom")) throw Cancelled();
  const Phantom phantom = loadPhantom(name);
  Phantom::Rasterised rasterised = phantom.rasterise(voxels);
  OpenedPhantom opened;
  opened.volume.format = "phantom";
  opened.volume.series.id = name;
  opened.volume.series.modality = "CT";
  opened.volume.series.description = phantom.name;
  opened.volume.series.dims = rasterised.volume->grid.dims;
  opened.volume.volume = std::move(rasterised.volume);
  opened.labels = std::move(rasterised.labels);
  return opened;
}

Phantom parsePhantom(std::string_view json, const std::string& source) { return Parser(source).parse(json); }

}  // namespace fenestra::io
