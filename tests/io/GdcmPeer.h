#pragma once
// DICOM files as GDCM reads them. GDCM runs in a program of its own: it and DCMTK each bring a CharLS of the same
// symbols.

#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::tests {

/// The record that the program writes of each file, followed by the stored words and the modality lookup table.
struct GdcmRecord {
  std::uint8_t isImage = 0, isSigned = 0;
  std::int32_t bitsAllocated = 0;
  glm::ivec3 dims{1};
  glm::dvec3 origin{0.0}, spacing{1.0}, row{0.0}, column{0.0};
  double slope = 1.0, intercept = 0.0;
  std::int32_t lutFirst = 0;
  std::uint64_t lutEntries = 0, wordBytes = 0;
};

struct GdcmImage {
  GdcmRecord header;
  std::vector<double> values;  ///< real, x fastest, frames in stored order
};

/// The files that are images, in the order given. `dose`: let the dose scaling count instead of a rescale.
std::vector<GdcmImage> readWithGdcm(const std::vector<std::filesystem::path>& files, bool dose = false);

}  // namespace fenestra::tests
