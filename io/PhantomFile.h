#pragma once
// Phantoms from their descriptions in resources/phantoms.

#include <string>
#include <string_view>
#include <vector>

#include "io/VolumeReader.h"
#include "rendering/volume/Phantom.h"

namespace fenestra::io {

/// Names of the built-in phantoms: "torso", "head".
std::vector<std::string> phantomNames();
/// A built-in phantom. Throws Error naming the phantoms there are.
Phantom loadPhantom(const std::string& name);
/// A built-in phantom as a data set (format "phantom") of `voxels` along its longest side. Throws Error, Cancelled.
struct OpenedPhantom {
  OpenedVolume volume;
  std::shared_ptr<const LabelMap> labels;
};
OpenedPhantom openPhantom(const std::string& name, int voxels, const Progress& progress = {});
/// Parses a description; `source` names it in errors. Throws Error.
Phantom parsePhantom(std::string_view json, const std::string& source);

}  // namespace fenestra::io
