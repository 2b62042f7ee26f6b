#pragma once
// Mosaics of Siemens and grids of United Imaging: the slices of a volume as tiles of one square picture. Include in
// .cpp files alone.

#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Turns the one frame of `file` into those of its tiles where it is such a picture; sets mosaicUnsplit instead where
/// the header does not give the layout.
void splitMosaic(DcmItem& dataset, DicomFile& file);

}  // namespace fenestra::io
