#include "io/session/LookFile.h"

#include <algorithm>

#include "io/base/AtomicFile.h"
#include "io/session/SceneJson.h"
#include "rendering/settings/LookStyle.h"

namespace fenestra::io {
namespace {

using json::Value;

constexpr const char* lookName = "fenestra-look";
std::string keyOf(const Label& label) { return label.name.empty() ? std::to_string(label.value) : label.name; }

constexpr std::uintmax_t largestLook = std::uintmax_t{1} << 20;  ///< ten thousand nodes

}  // namespace

void members(auto& io, json::Is<LabelFunction> auto& label) {
  io.required("label", label.label, {}, {"Its name, or its value in digits where it has none"});
  nodesMember(io, label.function, "Ascending");
}

void members(auto& io, json::Is<LookPreset> auto& preset) {
  auto& look = preset.look;
  io.required("name", preset.name, {}, {"What lists of presets show"});
  io("unit", preset.unit, {}, {"Of the nodes' values and the shift, as \"HU\"; empty where they have none"});
  nodesMember(io, look.context.function,
              "The transfer function of everything but the focus, before the shift, ascending");
  settings(io, look.context);  // shift
  io("focus_appearance", look.focusAppearance);
  partMembers(io, look);
  io.optional("labels", preset.labels, !preset.labels.empty(), {},
              {"Labels that are shown by value while they are in focus; others have one colour and extinction"});
}

LookPreset presetOf(const std::string& name, const SetScene& scene) {
  LookPreset preset{name, scene.volume->unit, styleOf(scene.look), {}, {}};
  if (scene.labels)
    for (const Label& label : scene.labels->labels)
      if (const auto function = settingFor(scene.look.labels, label.value).function)
        preset.labels.push_back({keyOf(label), *function});
  return preset;
}

Look restyled(const SetScene& scene, const LookPreset& preset) {
  SetScene result = scene;
  result.look = fenestra::restyled(scene.look, preset.look);
  setLabelFunctions(result, preset);
  return result.look;
}

void setLabelFunctions(SetScene& scene, const LookPreset& preset) {
  if (!scene.labels) return;
  for (const Label& label : scene.labels->labels) {
    LabelSetting setting = settingFor(scene.look.labels, label.value);
    const auto named = std::find_if(preset.labels.begin(), preset.labels.end(),
                                    [&](const LabelFunction& each) { return each.label == keyOf(label); });
    setting.function = named == preset.labels.end() ? std::nullopt : std::optional(named->function);
    put(scene.look.labels, setting);
  }
}

LookPreset readLook(const std::filesystem::path& file) {
  Value root = json::parse(file, json::readBounded(file, largestLook));
  const auto format = root.is_object() ? root.find("format") : root.end();
  if (format == root.end() || *format != lookName)
    throw Error(file, "is not a preset of a look", "give a file that Fenestra exported");
  const json::Place top{file};
  const json::Reader reader(top, root);
  int version = 0;
  reader.required("version", version, {1.0, 1e6});
  if (version > lookVersion)
    throw Error(file, "was written by a newer version of Fenestra", "open it with that version");
  LookPreset preset;
  members(reader, preset);
  Value rest = json::unknownIn(root, json::write(preset));
  if (rest.is_object()) {
    rest.erase("format");
    rest.erase("version");
    if (!rest.empty()) preset.unknown = rest.dump();
  }
  return preset;
}

void writeLook(const std::filesystem::path& file, const LookPreset& preset) {
  LookPreset written = preset;
  written.look = styleOf(preset.look);
  Value root{{"format", lookName}, {"version", lookVersion}};
  try {
    root.update(json::write(written));
    if (!preset.unknown.empty()) json::addUnknown(root, Value::parse(preset.unknown));
    writeText(file, json::textOf(root));
  } catch (const Value::type_error&) {
    throw Error(file, "cannot hold a name that is not UTF-8", "give the preset another name");
  }
}

std::string mismatchOf(const LookPreset& preset, const std::string& unit) {
  if (preset.unit == unit) return {};
  const auto named = [](const std::string& each) { return each.empty() ? "without a unit" : "in " + each; };
  return "the preset \"" + preset.name + "\" was made for values " + named(preset.unit) +
         "; those of this volume are " + named(unit);
}

std::string lookSchema() {
  Value schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "Fenestra preset of a look"},
      {"description",
       "How volumes are looked at, without a focus, strokes or a camera. Members that a version does not know "
       "are kept and written back. Lengths are mm; colours are display RGB, 0..1."},
  };
  Value members = json::schemaOf(LookPreset());
  Value properties{
      {"format", {{"const", lookName}}},
      {"version",
       {{"const", lookVersion}, {"description", "Raised only when an older program would misread the file"}}}};
  properties.update(members["properties"]);
  members["properties"] = std::move(properties);
  members["required"].insert(members["required"].begin(), {"format", "version"});
  schema.update(members);
  return json::textOf(schema);
}

}  // namespace fenestra::io
