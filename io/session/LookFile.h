#pragma once
// A user's preset: the style of a look (rendering/scene/LookStyle.h) as a JSON file of its own, for other volumes.
//
// { "format": "fenestra-look", "version": 1, "name": "Vessels", "unit": "HU", "nodes": […], "shift": 0, … }
//
// resources/session/fenestra-look.schema.json lists all members. A missing member has its default; members that this
// version does not know are kept and written back.

#include <filesystem>
#include <string>

#include "io/base/Error.h"
#include "rendering/scene/Look.h"

namespace fenestra::io {

inline constexpr int lookVersion = 1;

struct LookPreset {
  std::string name;     ///< what a list shows
  std::string unit;     ///< of the transfer function's values: that of the volume it was made on; empty: none
  Look look;            ///< its style; the rest has its defaults
  std::string unknown;  ///< as in Session
  bool operator==(const LookPreset&) const = default;
};

/// Throws Error.
LookPreset readLook(const std::filesystem::path& file);
/// Writes a temporary file beside `file` and renames it. Throws Error.
void writeLook(const std::filesystem::path& file, const LookPreset& preset);

/// What is odd about a preset on a volume whose values have that unit, for a warning; empty: nothing.
std::string mismatchOf(const LookPreset& preset, const std::string& unit);

/// What resources/session/fenestra-look.schema.json publishes.
std::string lookSchema();

}  // namespace fenestra::io
