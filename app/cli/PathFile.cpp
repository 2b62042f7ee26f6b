#include "app/cli/PathFile.h"

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "io/base/Error.h"
#include "io/session/Json.h"

namespace fenestra::cli {
namespace {

using Json = io::json::Value;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& cause) {
  throw io::Error(file, "is no path: " + cause,
                  R"(write {"points": [[l, p, s], ...]} with two points or more, mm in the patient (LPS))");
}

glm::dvec3 pointIn(const std::filesystem::path& file, const Json& value, std::size_t number) {
  glm::dvec3 point;
  if (!value.is_array() || value.size() != 3) fail(file, "point " + std::to_string(number) + " is not three numbers");
  for (int axis = 0; axis < 3; ++axis) {
    const Json& coordinate = value[static_cast<std::size_t>(axis)];
    // Farther than any scanner reaches, lengths of pictures would overflow.
    constexpr double farthest = 1e6;
    if (!coordinate.is_number() || !(std::abs(coordinate.get<double>()) <= farthest))
      fail(file, "point " + std::to_string(number) + " is not three numbers of at most a kilometre");
    point[axis] = coordinate.get<double>();
  }
  return point;
}

}  // namespace

std::vector<glm::dvec3> readPath(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = 1 << 22;
  constexpr std::size_t mostPoints = 20'000;
  const Json root = io::json::parse(file, io::json::readBounded(file, largest));
  if (!root.is_object()) fail(file, "it is not a JSON object");
  const auto list = root.find("points");
  if (list == root.end() || !list->is_array()) fail(file, "it has no list \"points\"");
  if (list->size() > mostPoints) fail(file, "it has more than " + std::to_string(mostPoints) + " points");
  std::vector<glm::dvec3> points;
  bool isLine = false;
  for (const Json& value : *list) {
    points.push_back(pointIn(file, value, points.size() + 1));
    isLine = isLine || glm::distance(points.front(), points.back()) > 0.01;
  }
  if (!isLine) fail(file, "it needs two points that differ");
  return points;
}

}  // namespace fenestra::cli
