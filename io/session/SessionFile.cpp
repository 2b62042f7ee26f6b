#include "io/session/SessionFile.h"

#include <algorithm>
#include <functional>
#include <system_error>

#include "io/HeaderText.h"
#include "io/ImageWriter.h"
#include "io/session/SceneJson.h"

namespace fenestra {

using io::json::Is;

void members(auto& io, Is<LabelFocus> auto& focus) { io.required("labels", focus.labels, {1.0, 65535.0}); }

void members(auto& io, Is<ValueFocus> auto& focus) {
  io.required("low", focus.values.low);
  io.required("high", focus.values.high);
  io("minimum_component", focus.minimumComponent, io::json::nonNegative);
}

namespace placement {

void members(auto& io, Is<Weights> auto& weights) {
  io("visibility", weights.visibility);
  io("coverage", weights.coverage);
  io("location", weights.location);
  io("entropy", weights.entropy);
  io("mutual_information", weights.mutualInformation);
  io("stability", weights.stability);
  io("orientation", weights.orientation);
}

}  // namespace placement

namespace io {
namespace {

namespace fs = std::filesystem;
using json::Value;

constexpr const char* formatName = "fenestra-session";
/// Room for a million anchors; what bounds the memory that a file can ask for is json::parse.
constexpr std::uintmax_t largest = std::uintmax_t{64} << 20;
constexpr double largestPicture = 16384.0;  ///< pixels a side, what OpenGL 4.5 drivers commonly offer

json::Words<ScalarType> scalarTypes() {
  json::Words<ScalarType> words;
  for (const ScalarType type : {ScalarType::UInt8, ScalarType::Int8, ScalarType::UInt16, ScalarType::Int16,
                                ScalarType::UInt32, ScalarType::Int32, ScalarType::Float32, ScalarType::Float64})
    words.emplace_back(nameOf(type), type);
  return words;
}

}  // namespace
}  // namespace io

inline io::json::Words<ScalarType> wordsOf(ScalarType) { return io::scalarTypes(); }

namespace io {

void members(auto& io, Is<RawDescription> auto& raw) {
  io.required("dims", raw.dims, {1.0, 1e6});
  io.required("type", raw.type);
  io("big_endian", raw.bigEndian);
  io("skip", raw.skip);
  io("spacing", raw.spacing, json::positiveMillimetres);
}

void members(auto& io, Is<SessionData> auto& data) {
  io.required("path", data.path);
  const bool known = !data.contents.hash.empty();
  json::optional(io, "contents", data.contents.hash, known);
  json::optional(io, "bytes", data.contents.bytes, known);
  json::optional(io, "files", data.contents.files, known);
}

void members(auto& io, Is<SessionVolume> auto& volume) {
  members(io, static_cast<std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(volume)>>,
                                             const SessionData, SessionData>&>(volume));
  json::optional(io, "series", volume.series, !volume.series.empty());
  json::optional(io, "raw", volume.raw, volume.raw.has_value());
}

void members(auto& io, Is<SessionPhantom> auto& phantom) {
  io.required("name", phantom.name);
  io("voxels", phantom.voxels, {1.0, 1024.0});
}

void members(auto& io, Is<SessionView> auto& view) {
  io.required("camera", view.camera);
  io("size", view.size, {1.0, largestPicture});
  io("pixel_scale", view.pixelScale, {0.01, 100.0});
  io("fits_width", view.fitsWidth);
}

void members(auto& io, Is<SessionPlacement> auto& placement) {
  io("samples", placement.samples, {12.0, 12288.0});
  io("refined", placement.refined);
  io("weights", placement.weights);
  io("in_stream", placement.inStream);
  io("stream_half_width", placement.streamHalfWidth, {0.0, 90.0});
  io("share_weight", placement.shareWeight, json::fraction);
  io("joint", placement.joint);
  io("follow", placement.follow);
  io("automatic", placement.automatic);
}

void members(auto& io, Is<SessionOverlays> auto& overlays) {
  io("crosshair", overlays.crosshair);
  io("text", overlays.text);
  io("labels", overlays.labels);
}

namespace {

void focusMember(json::Writer& io, const Focus& focus) {
  if (const auto* labels = std::get_if<LabelFocus>(&focus))
    io("focus", *labels);
  else if (const auto* values = std::get_if<ValueFocus>(&focus))
    io("focus", *values);
}
void focusMember(const json::Reader& io, Focus& focus) {
  if (io["focus"].is_null()) return;
  if (io["focus"].contains("labels"))
    io("focus", focus.emplace<LabelFocus>());
  else
    io("focus", focus.emplace<ValueFocus>());
}

}  // namespace

void members(auto& io, Is<Session> auto& session) {
  json::optional(io, "volume", session.volume, !session.volume.path.empty());
  json::optional(io, "phantom", session.phantom, session.phantom.has_value());
  json::optional(io, "labels", session.labels, !session.labels.path.empty());
  focusMember(io, session.look.focus);
  io("focus_appearance", session.look.focusAppearance);
  io.required("context", session.look.context);
  io("cutaway", session.look.cutaway);
  io("context_layer", session.look.contextLayer);
  io("shading", session.look.shading);
  io("background", session.look.background, json::fraction);
  io("quality", session.quality);
  json::optional(io, "max_error", session.maxError, session.maxError.has_value(), {0.05, 255.0});
  io.required("views", session.views);
  io("home", session.home);
  io("linked", session.linked);
  json::optional(io, "window", session.window, session.window.has_value());
  json::optional(io, "crosshair", session.crosshair, session.crosshair.has_value());
  io("overlays", session.overlays);
  json::optional(io, "maximised", session.maximised, !session.maximised.empty());
  json::optional(io, "layout", session.layout, !session.layout.empty());
  io("placement", session.placement);
  io("strokes", session.look.strokes);
  json::optional(io, "autosave_of", session.autosaveOf, !session.autosaveOf.empty());
}

namespace {

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

/// migrations[i] brings version i + 1 to the next.
constexpr void (*migrations[])(Value&) = {fromVersion1};
static_assert(std::size(migrations) == sessionVersion - 1);

/// The folder that a session's paths start from, without links, so that ".." means what the system takes it for.
fs::path folderOf(const fs::path& file) {
  std::error_code failure;
  const fs::path folder = fs::absolute(file).parent_path();
  const fs::path canonical = fs::canonical(folder, failure);
  return failure ? folder.lexically_normal() : canonical;
}

/// Without "." and "..", and without a slash at the end, behind which a folder has no name.
fs::path tidy(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  return normal.has_filename() || !normal.has_relative_path() ? normal : normal.parent_path();
}

/// Every path of a session.
template <class F>
void forEachPath(Session& session, F&& change) {
  for (fs::path* path : {&session.volume.path, &session.labels.path, &session.look.context.file, &session.autosaveOf})
    if (!path->empty()) change(*path);
}

void refuseUnless(bool right, const json::Reader& top, const char* problem) {
  if (!right) top.fail(problem);
}

template <class T, class Less>
bool isOrdered(const std::vector<T>& list, Less less) {
  return std::is_sorted(list.begin(), list.end(), less);
}

/// What members cannot say one by one.
void check(const Session& session, const json::Reader& top) {
  const bool hasVolume = !session.volume.path.empty();
  refuseUnless(hasVolume != session.phantom.has_value(), top, "names neither one volume nor one phantom");
  if (const auto* labels = std::get_if<LabelFocus>(&session.look.focus)) {
    refuseUnless(!session.labels.path.empty() || session.phantom, top, "has a focus of labels, but no labels");
    refuseUnless(!labels->labels.empty() && isOrdered(labels->labels, std::less_equal<>()), top,
                 "has labels in the focus that are not in order, each once");
  }
  if (const auto* values = std::get_if<ValueFocus>(&session.look.focus))
    refuseUnless(values->values.low <= values->values.high, top, "has a focus of values that ends before it begins");
  refuseUnless(
      isOrdered(session.look.context.function.nodes, [](const auto& a, const auto& b) { return a.value < b.value; }),
      top, "has a transfer function whose nodes are not in order");
}

}  // namespace

bool isSession(const fs::path& path) { return lowered(path.extension().string()) == sessionEnding; }

Session readSession(const fs::path& file) {
  Value root = json::parse(file, json::readBounded(file, largest));
  const auto format = root.is_object() ? root.find("format") : root.end();
  if (format == root.end() || *format != formatName)
    throw Error(file, "is no session", "give a .fenestra file that Fenestra wrote");
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
  Value root{{"format", formatName}, {"version", sessionVersion}};
  try {
    root.update(json::write(written));
    if (!session.unknown.empty()) json::addUnknown(root, Value::parse(session.unknown));
    return json::textOf(root);
  } catch (const Value::type_error&) {
    throw Error(file, "cannot hold a file name that is not UTF-8", "rename the data, and open them under the new name");
  }
}

void writeSession(const fs::path& file, const Session& session) { writeText(file, textOf(session, file)); }

}  // namespace io
}  // namespace fenestra
