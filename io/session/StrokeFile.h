#pragma once
// Brush strokes as a JSON file of their own, to be applied to another camera, session or picture:
//
// { "format": "fenestra-strokes", "version": 1, "strokes": [ {"mode": "restore" | "open" | "fade" | "strengthen",
//   "anchors": [[x, y, z], …] (world, mm), "radius": mm, "softness": 0..1, "depth": mm, "amount": 0..1,
//   "to_surface": false, "covers_focus": false, "hidden": false, "view": -1 (all) | 0 (C1) | 1 (C2)}, … ] }
//
// A missing member has its default of rendering/settings/BrushStroke.h. In a session, "strokes" is the same list.

#include <filesystem>

#include "io/base/Error.h"
#include "rendering/settings/BrushStroke.h"

namespace fenestra::io {

/// Throws Error.
BrushStrokes readStrokes(const std::filesystem::path& file);
/// Writes a temporary file beside `file` and renames it. Throws Error.
void writeStrokes(const std::filesystem::path& file, const BrushStrokes& strokes);

}  // namespace fenestra::io
