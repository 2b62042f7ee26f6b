#pragma once
// Structure sets (RTSTRUCT, PS3.3 C.8.8.5 and C.8.8.6): contours as labels. Include in .cpp files alone.

#include "io/base/LabelReading.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io {

/// `dataset` is a whole structure set. Closed planar contours are filled by the even-odd rule; a voxel takes the
/// contours of the plane nearest to it, up to half the structure's usual distance between planes beyond its ends.
/// Points and open contours enclose nothing and are counted in a warning. A label is the ROI number, or the next free
/// value where that is none. Throws Error, Cancelled.
LabelsOnGrid readStructureSet(DcmDataset& dataset, const std::filesystem::path& path, const Grid& target,
                              const Progress& progress);

}  // namespace fenestra::io
