#pragma once
// Tables of labels' names and colours, as programs for segmentations write them.

#include <filesystem>
#include <vector>

#include "rendering/volume/LabelMap.h"

namespace fenestra::io {

/// The rows of a table, in the file's order, without the background 0; a label without a colour has noColour. Kinds:
/// - ITK-SNAP:                value R G B A visible mesh "name"   (R, G, B from 0 to 255)
/// - FreeSurfer, 3D Slicer:   value name R G B A
/// - BIDS, and 3D Slicer's CSV: columns that a first line names: index or value, name, and color as #RRGGBB or
///   Color_R, Color_G and Color_B; tabs, commas or semicolons divide the cells, which may be quoted
/// - plain:                   value name, divided by tabs or blanks
/// Text is UTF-8, or UTF-16 behind a byte order mark. Other lines are headings or comments. Empty where no line is a
/// row. Throws Error when the file cannot be read.
std::vector<Label> readLabelTable(const std::filesystem::path& file);

/// The table that belongs to a label map by its name: the map's own with .txt, .tsv, .csv, .label, .ctbl or .lut;
/// "labels.tsv", "labels.txt" or "FreeSurferColorLUT.txt" in its folder; for a map of BIDS ("…_dseg"), the last
/// entities of its name with .tsv, in its folder or the three above. Empty: there is none.
std::filesystem::path tableBeside(const std::filesystem::path& labels);

}  // namespace fenestra::io
