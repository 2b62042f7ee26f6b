#pragma once
// Frames that belong together but share places: parted into volumes with one frame a place. Geometry and the attributes
// of ImageParts.h alone.

#include <string>
#include <vector>

#include "io/dicom/DicomFile.h"

namespace fenestra::io {

struct PartedFrames {
  std::vector<std::vector<DicomFrame>> volumes;  ///< by time; each in the order of its places
  std::vector<DicomFrame> dropped;               ///< at places that other frames have already
  std::string by;            ///< the attributes that part them, "trigger time, acquisition number"; may be empty
  std::size_t places = 0;    ///< along the normal; a volume with fewer frames is incomplete
  bool interleaved = false;  ///< no place repeats, but the volumes are even and their union is not
};

/// Order among frames at one position: by time, then as acquired, then as stored.
bool earlier(const DicomFrame& a, const DicomFrame& b);

/// Parts `frames`, parallel slices with geometry, in this order:
/// - An attribute parts frames whose places repeat, where the volumes of its values together are as many as before, and
///   one value has a frame at every place. So an acquisition that was broken off leaves the whole ones as they are, and
///   a few slices that two acquisitions share part none.
/// - Frames that no attribute parts are numbered at each place, where every place has as many; otherwise they start a
///   volume each time that a place comes again in stored order, where all of these but the last are whole. Otherwise
///   the first frames of each place remain, and the others are dropped.
/// - Where no place repeats, an attribute parts frames whose values are each evenly spaced and interleaved, while their
///   union is uneven.
PartedFrames partRepeats(std::vector<DicomFrame> frames, const glm::dvec3& normal);

}  // namespace fenestra::io
