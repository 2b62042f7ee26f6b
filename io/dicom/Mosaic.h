#pragma once
// Siemens mosaics: the slices of a volume as tiles of one square picture. Include in .cpp files alone.

#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Turns the one frame of `file` into those of its tiles; sets mosaicUnsplit instead where the header does not give the
/// layout.
void splitMosaic(DcmItem& dataset, DicomFile& file);

}  // namespace fenestra::io
