#pragma once
// A user's preset: the style of a look (rendering/settings/LookStyle.h) as a JSON file of its own, for other volumes.
//
// { "format": "fenestra-look", "version": 1, "name": "Vessels", "unit": "HU", "nodes": […], "shift": 0, …,
//   "labels": [{ "label": "liver", "nodes": […] }] }
//
// resources/session/fenestra-look.schema.json lists all members. A missing member has its default; members that this
// version does not know are kept and written back.

#include <filesystem>
#include <string>
#include <vector>

#include "io/base/Error.h"
#include "rendering/scene/SetScene.h"

namespace fenestra::io {

inline constexpr int lookVersion = 1;

/// The function of a label in focus, by the label's name, or by its value in digits where it has no name: other data
/// may have other values for the same structures.
struct LabelFunction {
  std::string label;
  TransferFunction function;
  bool operator==(const LabelFunction&) const = default;
};

struct LookPreset {
  std::string name;     ///< what a list shows
  std::string unit;     ///< of the transfer functions' values: that of the volume it was made on; empty: none
  Look look;            ///< its style; the rest has its defaults
  std::string unknown;  ///< as in Session
  std::vector<LabelFunction> labels{};  ///< those that have one, as a label map lists them
  bool operator==(const LookPreset&) const = default;
};

/// How a scene is looked at, as a preset.
LookPreset presetOf(const std::string& name, const SetScene& scene);
/// The scene's look in the style of a preset, its labels' functions included.
Look restyled(const SetScene& scene, const LookPreset& preset);
/// Gives the scene's labels the functions that the preset names, and no others.
void setLabelFunctions(SetScene& scene, const LookPreset& preset);

/// Throws Error.
LookPreset readLook(const std::filesystem::path& file);
/// Writes a temporary file beside `file` and renames it. Throws Error.
void writeLook(const std::filesystem::path& file, const LookPreset& preset);

/// What is odd about a preset on a volume whose values have that unit, for a warning; empty: nothing.
std::string mismatchOf(const LookPreset& preset, const std::string& unit);

/// What resources/session/fenestra-look.schema.json publishes.
std::string lookSchema();

}  // namespace fenestra::io
