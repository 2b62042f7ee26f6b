#include "io/session/CameraFile.h"

#include <cmath>
#include <fstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "io/base/AtomicFile.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const fs::path& path, const std::string& cause) {
  throw Error(path, "not a camera: " + cause, "use a camera.json that Fenestra wrote beside the layers of a picture");
}

[[noreturn]] void fail(const fs::path& path, const char* key, const char* problem) {
  fail(path, std::string(key) + " " + problem);
}

double number(const fs::path& path, const Json& value, const char* key) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) fail(path, key, "is not made of numbers");
  return value.get<double>();
}

template <int N>
glm::vec<N, double> vector(const fs::path& path, const Json& root, const char* key) {
  const auto at = root.find(key);
  if (at == root.end() || !at->is_array() || at->size() != N)
    fail(path, key, N == 2 ? "is not a list of two" : "is not a list of three");
  glm::vec<N, double> result;
  for (int i = 0; i < N; ++i) result[i] = number(path, (*at)[static_cast<std::size_t>(i)], key);
  return result;
}

double positive(const fs::path& path, const Json& root, const char* key, double limit) {
  const auto at = root.find(key);
  if (at == root.end()) fail(path, key, "is missing");
  const double value = number(path, *at, key);
  if (!(value > 0.0 && value < limit)) fail(path, key, "is out of range");
  return value;
}

}  // namespace

CameraFile readCamera(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw Error(path, "no such file", "check the path");
  constexpr std::uintmax_t largest = 1 << 20;
  if (fs::file_size(path, error) > largest || error) fail(path, "too large");
  std::ifstream stream(path, std::ios::binary);
  Json root;
  try {
    root = Json::parse(stream);
  } catch (const Json::parse_error& parse) {
    fail(path, "not valid JSON near byte " + std::to_string(parse.byte));
  }
  if (!root.is_object()) fail(path, "the top level is not an object");

  CameraFile file;
  const auto projection = root.find("projection");
  if (projection != root.end() && *projection == "perspective") {
    file.camera.projection = Projection::Perspective;
  } else if (projection != root.end() && *projection == "orthographic") {
    file.camera.projection = Projection::Orthographic;
  } else {
    fail(path, "projection", "is neither \"perspective\" nor \"orthographic\"");
  }
  file.camera.eye = vector<3>(path, root, "eye_world");
  file.camera.target = vector<3>(path, root, "target");
  file.camera.up = vector<3>(path, root, "up");
  file.camera.verticalFov = positive(path, root, "vertical_fov", 180.0);
  file.camera.orthographicHeight = positive(path, root, "orthographic_height", 1e12);
  const glm::dvec2 size = vector<2>(path, root, "size");
  constexpr double widest = 16384.0;
  if (!(size.x >= 1.0 && size.x <= widest && size.y >= 1.0 && size.y <= widest)) fail(path, "size", "is out of range");
  file.size = glm::ivec2(size);
  return file;
}

void writeCamera(const fs::path& path, const CameraFile& file, const Grid& grid) {
  const Camera& camera = file.camera;
  const auto list = [](glm::dvec3 v) { return Json{v.x, v.y, v.z}; };
  const glm::dmat4 clip = camera.clipFromWorld(static_cast<double>(file.size.x) / file.size.y, grid);
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) rows.push_back({clip[0][row], clip[1][row], clip[2][row], clip[3][row]});
  const Json root{
      {"size", {file.size.x, file.size.y}},
      {"projection", camera.projection == Projection::Perspective ? "perspective" : "orthographic"},
      {"eye_world", list(camera.eye)},
      {"target", list(camera.target)},
      {"up", list(camera.up)},
      {"vertical_fov", camera.verticalFov},
      {"orthographic_height", camera.orthographicHeight},
      {"clipFromWorld", std::move(rows)},
  };
  writeText(path, root.dump(2) + "\n");
}

}  // namespace fenestra::io
