#pragma once
// Transfer functions as JSON: the presets in resources/transfer-functions and the user's own files.
//
// { "name": "CT bone", "domain": "value" | "percentile",
//   "nodes": [ {"value": 150, "colour": [r,g,b], "opacity": o}, … ] }
// Nodes are in ascending order of value; two of the same value make a step. colour is display RGB 0..1, opacity that of
// 1 mm of material. With "percentile", values are 0..100 and are mapped through the volume's own value distribution,
// because MR values have no unit. The distribution is that of the tissue: background (air and its noise) is left out,
// by the threshold that separates the volume's two main classes best (Otsu's), so that percentile 0 is where tissue
// begins.

#include <filesystem>
#include <string>
#include <vector>

#include "io/base/Error.h"
#include "rendering/settings/Look.h"
#include "rendering/volume/Volume.h"

namespace fenestra::io {

struct TransferFunctionPreset {
  std::string id;    ///< "ct-bone"; the command line's name for it
  std::string name;  ///< "CT bone"
};
/// The built-in presets, in the order a menu shows them.
std::vector<TransferFunctionPreset> transferFunctionPresets();
/// A preset by id, or a file by path, made for `volume` and not shifted. Throws Error.
ContextFunction loadContextFunction(const std::string& presetOrPath, const Volume& volume);
/// The preset to start with, by modality and value range: CT in HU gets "ct-soft-tissue", all else (MR, CT that is not
/// in HU) the percentile-based "mr".
std::string defaultPreset(const Volume& volume);

}  // namespace fenestra::io
