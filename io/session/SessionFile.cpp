#include "io/session/SessionFile.h"

#include <algorithm>
#include <functional>
#include <system_error>

#include "io/base/AtomicFile.h"
#include "io/session/SessionJson.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;
using json::Value;

/// Enough for a million anchors; json::parse bounds the memory that a file can ask for.
constexpr std::uintmax_t largestSession = std::uintmax_t{128} << 20;

/// Each seed takes the time of a small filter; see segmentation::growRegion.
constexpr std::size_t mostSeeds = 10000;

/// Version 1 had the data's paths alone, cameras without their pictures, and the widths under their symbols.
void fromVersion1(Value& root) {
  for (const char* data : {"volume", "labels"})
    if (root.contains(data)) root[data] = {{"path", root[data]}};
  if (root.contains("cameras") && root["cameras"].is_array()) {
    Value views = Value::array();
    for (const Value& camera : root["cameras"]) views.push_back({{"camera", camera}});
    root["views"] = std::move(views);
    root.erase("cameras");
  }
  if (root.contains("cutaway") && root["cutaway"].is_object())
    for (const auto& [symbol, name] : {std::pair("w_open", "open_width"), std::pair("w_border", "border_width")})
      if (root["cutaway"].contains(symbol)) {
        root["cutaway"][name] = root["cutaway"][symbol];
        root["cutaway"].erase(symbol);
      }
}

/// Version 2 had another rule for the Automatic reconstruction, which depends on the data: Session::formerAutomatic.
void fromVersion2(Value&) {}

/// In version 3 a label's opacity was that of 10 mm of it, as a share of what they had at 1. It becomes what a body of
/// 30 mm showed of itself, as organs have it.
void fromVersion3(Value& root) {
  const auto settings = root.find("label_settings");
  if (settings == root.end() || !settings->is_array()) return;
  for (Value& setting : *settings) {
    if (!setting.is_object() || !setting.contains("opacity") || !setting["opacity"].is_number()) continue;
    const double clear = 1.0 - setting["opacity"].get<double>();
    setting["opacity"] = 1.0 - clear * clear * clear;
  }
}

/// migrations[i] brings version i + 1 to the next.
constexpr void (*migrations[])(Value&) = {fromVersion1, fromVersion2, fromVersion3};
static_assert(std::size(migrations) == sessionVersion - 1);

/// The folder that a session's paths start from, without links, so that ".." means the same as to the system.
fs::path folderOf(const fs::path& file) {
  std::error_code failure;
  const fs::path folder = fs::absolute(file).parent_path();
  const fs::path canonical = fs::canonical(folder, failure);
  return failure ? folder.lexically_normal() : canonical;
}

/// Without "." and "..", and without a slash at the end, so that a folder has a file name.
fs::path tidy(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  return normal.has_filename() || !normal.has_relative_path() ? normal : normal.parent_path();
}

/// Every path of a session.
template <class F>
void forEachPath(Session& session, F&& change) {
  for (fs::path* path : {&session.volume.path, &session.labels.path, &session.labels.table, &session.look.context.file,
                         &session.autosaveOf})
    if (!path->empty()) change(*path);
  for (KeyImage& image : session.keyImages)
    if (fs::path& path = image.look.context.file; !path.empty()) change(path);
}

void refuseUnless(bool right, const json::Reader& top, const char* problem) {
  if (!right) top.fail(problem);
}

/// Refuses what spans several members of a look. `hasLabels`: the session names some.
void checkLook(const Look& look, bool hasLabels, const json::Reader& top) {
  const LabelSettings& settings = look.labels;
  const auto follow = [](const LabelSetting& a, const LabelSetting& b) { return a.label >= b.label; };
  refuseUnless(std::adjacent_find(settings.begin(), settings.end(), follow) == settings.end(), top,
               "has settings of labels that do not ascend");
  if (const auto* labels = std::get_if<LabelFocus>(&look.focus)) {
    refuseUnless(hasLabels, top, "has a focus of labels, but no labels");
    refuseUnless(
        !labels->labels.empty() && std::is_sorted(labels->labels.begin(), labels->labels.end(), std::less_equal<>()),
        top, "has labels in the focus that do not ascend");
  }
  if (const auto* values = std::get_if<ValueFocus>(&look.focus))
    refuseUnless(values->values.low <= values->values.high, top, "has a focus of values whose low exceeds its high");
  if (const auto* region = std::get_if<RegionFocus>(&look.focus)) {
    refuseUnless(!region->empty(), top, "has a region in the focus without a seed inside or a stroke");
    refuseUnless(std::all_of(region->painted.begin(), region->painted.end(),
                             [](const SelectionStroke& stroke) { return !stroke.anchors.empty(); }),
                 top, "has a painted region with a stroke of no points");
    refuseUnless(region->inside.size() + region->outside.size() <= mostSeeds, top,
                 "has a region in the focus with more seeds than anybody clicks");
  }
}

void checkPlanes(const std::array<SessionPlane, 3>& planes, const json::Reader& top) {
  refuseUnless(std::all_of(planes.begin(), planes.end(),
                           [](const SessionPlane& plane) { return !plane.axes || isPerpendicular(*plane.axes); }),
               top, "has a slice whose axes are no perpendicular unit vectors");
}

/// Refuses what spans several members.
void check(const Session& session, const json::Reader& top) {
  const bool hasVolume = !session.volume.path.empty();
  refuseUnless(hasVolume != session.phantom.has_value(), top, "must name either a volume or a phantom");
  checkLook(session.look, !session.labels.path.empty() || session.phantom, top);
  refuseUnless(std::all_of(session.measures.begin(), session.measures.end(), isWellFormed), top,
               "has a measure without the points, the plane or the text that its kind needs");
  checkPlanes(session.planes, top);
  refuseUnless(session.path.size() != 1 && session.path.size() <= mostPathPoints, top,
               "has a path of one point, or of more than anybody clicks");
  refuseUnless(session.keyImages.size() <= KeyImage::most, top, "has more key images than anybody keeps");
  for (const KeyImage& image : session.keyImages) {
    refuseUnless(image.name.size() <= KeyImage::longestName, top, "has a key image with too long a name");
    refuseUnless(image.picture.size() <= KeyImage::largestPicture, top, "has a key image with too large a picture");
    // Labels may be gone since it was made: then the window leaves them out.
    checkLook(image.look, true, top);
    checkPlanes(image.planes, top);
  }
}

}  // namespace

Session readSession(const fs::path& file) {
  Value root = json::parse(file, json::readBounded(file, largestSession));
  const auto format = root.is_object() ? root.find("format") : root.end();
  if (format == root.end() || *format != sessionFormat)
    throw Error(file, "is not a session", "give a .fenestra file that Fenestra wrote");
  const json::Place top{file};
  const json::Reader reader(top, root);
  int version = 0;
  reader.required("version", version, {1.0, 1e6});
  if (version > sessionVersion)
    throw Error(file, "was written by a newer version of Fenestra", "open it with that version");
  for (int from = version; from < sessionVersion; ++from) migrations[from - 1](root);
  root["version"] = sessionVersion;

  Session session;
  members(reader, session);
  session.formerAutomatic = version < 3 && session.look.reconstruction == Reconstruction::Auto;
  if (!reader.has("home"))
    for (std::size_t view = 0; view < session.views.size(); ++view) session.home[view] = session.views[view].camera;
  check(session, reader);
  forEachPath(session, [&](const fs::path& path) {
    if (path.is_absolute() || path.string().find('\0') != std::string::npos)
      throw Error(file, "names data by a path that is not relative to the session",
                  "write the path as seen from the session's folder");
  });

  const Value unknown = json::unknownIn(root, json::write(session));
  Value rest = unknown;
  if (rest.is_object()) {
    rest.erase("format");
    rest.erase("version");
    if (!rest.empty()) session.unknown = rest.dump();
  }
  const fs::path folder = folderOf(file);
  forEachPath(session, [&](fs::path& path) { path = tidy(folder / path); });
  return session;
}

std::string textOf(const Session& session, const fs::path& file) {
  Session written = session;
  const fs::path folder = folderOf(file);
  forEachPath(written, [&](fs::path& path) {
    path = tidy(fs::absolute(path));
    path = (folderOf(path) / path.filename()).lexically_relative(folder);
  });
  Value root{{"format", sessionFormat}, {"version", sessionVersion}};
  try {
    root.update(json::write(written));
    if (!session.unknown.empty()) json::addUnknown(root, Value::parse(session.unknown));
    return json::textOf(root);
  } catch (const Value::type_error&) {
    throw Error(file, "cannot hold a file name that is not UTF-8", "rename the data, and open them under the new name");
  }
}

void writeSession(const fs::path& file, const Session& session) { writeText(file, textOf(session, file)); }

}  // namespace fenestra::io
