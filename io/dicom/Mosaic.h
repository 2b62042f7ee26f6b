#pragma once
// Mosaics of Siemens and grids of United Imaging: the slices of a volume as tiles of one square picture. Include in
// .cpp files alone.

#include <optional>

#include <glm/glm.hpp>

#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Turns the one frame of `file` into those of its tiles where it is such a picture; sets mosaicUnsplit instead where
/// the header does not give the layout.
void splitMosaic(DcmItem& dataset, DicomFile& file);

/// What places the slices of a Siemens mosaic.
struct SiemensMosaic {
  double slices = 0.0;
  glm::dvec3 normal{0.0};  ///< from each slice to the next, a unit vector in LPS
};
/// Empty where the private header does not give it.
std::optional<SiemensMosaic> siemensMosaic(DcmItem& dataset);
/// Puts a private header with these numbers and nothing else in place of any other.
void writeSiemensMosaic(const SiemensMosaic& mosaic, DcmItem& dataset);

}  // namespace fenestra::io
