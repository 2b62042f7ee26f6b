#include "io/session/StrokeFile.h"

#include "io/base/AtomicFile.h"
#include "io/session/SceneJson.h"

namespace fenestra::io {
namespace {

constexpr const char* strokesName = "fenestra-strokes";
constexpr int newestVersion = 1;
constexpr std::uintmax_t largestStrokes = std::uintmax_t{128} << 20;

}  // namespace

BrushStrokes readStrokes(const std::filesystem::path& file) {
  const json::Value root = json::parse(file, json::readBounded(file, largestStrokes));
  const json::Place top{file};
  const json::Reader reader(top, root);
  std::string format;
  int version = 0;
  reader("format", format);
  if (format != strokesName) throw Error(file, "is not a file of strokes", "give one that Fenestra wrote");
  reader("version", version, {1.0, 1e6});
  if (version > newestVersion)
    throw Error(file, "was written by a newer version of Fenestra", "open it with that version");
  BrushStrokes strokes;
  reader("strokes", strokes);
  return strokes;
}

void writeStrokes(const std::filesystem::path& file, const BrushStrokes& strokes) {
  json::Value root;
  json::Writer writer(root);
  writer("format", std::string(strokesName));
  writer("version", newestVersion);
  writer("strokes", strokes);
  writeText(file, json::textOf(root));
}

}  // namespace fenestra::io
