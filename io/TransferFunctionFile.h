#pragma once
// Transfer functions as JSON: the presets in resources/transfer-functions and the user's own files.
//
// { "name": "CT bone", "domain": "value" | "hounsfield" | "percentile" | "tissue" | "uptake",
//   "nodes": [ {"value": 150, "colour": [r,g,b], "opacity": o, "per": "mm" | "voxel"}, … ] }
// Nodes are in ascending order of value; two of the same value make a step. colour is display RGB 0..1, opacity that of
// 1 mm of material, or of the finest spacing of the voxels: a surface such as the skin is as thin as they are. With
// "hounsfield", values are HU; where a CT is in other units, the nodes follow the units that its values seem to have
// (rendering/segmentation/HounsfieldScale.h), and in a volume that is spread as no CT they stand as written. With
// "uptake", values are standardised uptake values; where the volume is in another unit than g/ml, multiples of the mean
// of its tissue, which is 1 in a whole body by that value's definition. With "percentile", values are 0..100 and are
// mapped through the volume's own value distribution, because MR values have no unit. The distribution is that of the
// tissue: background (air and its noise) is left out, by the threshold that separates the volume's two main classes
// best (Otsu's), so that percentile 0 is where tissue begins. "tissue" is the same with air and its noise alone left
// out, so that skin and other dark tissue counts, and 0 is the surface of the body.

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
/// The preset to start with. CT gets "ct-soft-tissue", in HU or in units that its values tell, emission "pet",
/// ultrasound "ultrasound"; all else, of which only the distribution of the values says more, "mr-angio" where a few of
/// the tissue's voxels are far brighter than the rest, "mr-t2" where many are (fluid), and else "mr-t1".
std::string defaultPreset(const Volume& volume);
/// What defaultPreset() names, made for `volume`. The values are looked at once for both.
ContextFunction startingContext(const Volume& volume);
/// The preset of the plain and the bare look: "ct-plain" for CT in HU, "mr" for all else.
std::string plainPreset(const Volume& volume);

}  // namespace fenestra::io
