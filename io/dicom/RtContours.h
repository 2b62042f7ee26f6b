#pragma once
// The contours of a structure set (PS3.3 C.8.8.5 and C.8.8.6), as points. Include in .cpp files alone.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "io/base/LabelReading.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io {

using Contour = std::vector<glm::dvec3>;  ///< closed, LPS mm

struct Structure {
  std::int64_t number = 0;
  Label label;
  std::vector<Contour> contours;
};

struct StructureSet {
  std::vector<Structure> structures;
  std::size_t open = 0;              ///< contours that enclose nothing
  std::vector<std::string> faults;   ///< of contours that cannot be read, each with its structure's name
  std::size_t undescribed = 0;       ///< contours of structures that the file does not describe,
  std::set<std::int64_t> strangers;  ///< and the numbers of these
};

/// Structures come in the file's order, with unique labels. A contour that cannot be read is left out and counted: the
/// others are as good as without it. Throws Error when every contour had to be left out.
StructureSet readContours(DcmDataset& dataset, const std::filesystem::path& path);

/// Says which contours were left out and why.
void warnOfLeftOut(const StructureSet& set, const std::filesystem::path& path, std::vector<Warning>& warnings);

}  // namespace fenestra::io
