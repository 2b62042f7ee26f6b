#pragma once
// Whether the slices of a series are resampled onto even planes; io/dicom/Regular.h says how.

#include <cstdint>

namespace fenestra::io {

enum class Regularise : std::uint8_t {
  Automatic,  ///< linearly, where evenly spread slices would lie more than 0.01 mm from their places; a tilt stays
  Linear,     ///< to a straight box of voxels, by linear interpolation
  Cubic,      ///< to a straight box of voxels, by cubic interpolation
  Off         ///< never: the slices are spread evenly between the first and the last
};

}  // namespace fenestra::io
