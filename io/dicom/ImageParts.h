#pragma once
// Which attributes part the images of one series into several volumes.
//
// Attributes of the first kind say what an image shows: two images that differ there never belong to one volume,
// however well their places fit together. A slice that is missing among those of one value stays missing. Attributes of
// the second kind say when it was acquired or how it was named. They vary within a volume, too, as acquisition numbers
// do in a CT of several table positions: they part images only where places repeat, or where two interleaved sets of
// slices are even and their union is not (Repeats.h). One even volume that results without them stays one.
//
// Numbers are compared to four digits, because writers round them.

#include <string>
#include <vector>

#include "io/dicom/Dataset.h"

namespace fenestra::io {

enum class Parting : std::uint8_t { Always, WherePlacesRepeat };

struct PartingAttribute {
  const char* name;  ///< as messages call it
  const char* unit;  ///< behind the value; may be empty
  Parting parting;
};
/// The rows of the table, those of Parting::Always first.
const std::vector<PartingAttribute>& partingAttributes();

/// The values of the attributes for frame `index` (from 0) of a file, in their order; empty where they are not given.
std::vector<std::string> partsOf(const Scopes& scopes, int index);

/// The reconstruction kernel among the values of partsOf.
std::string kernelOf(const std::vector<std::string>& parts);

/// "echo time 4.92 ms"; "no echo time" for an empty value.
std::string partText(std::size_t attribute, const std::string& value);

}  // namespace fenestra::io
