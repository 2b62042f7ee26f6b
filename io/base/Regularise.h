#pragma once
// Whether the slices of a series are resampled onto even planes; io/dicom/Regular.h says how.

#include <array>
#include <cstdint>

#include "rendering/scene/Settings.h"

namespace fenestra::io {

enum class Regularise : std::uint8_t {
  Automatic,  ///< linearly, where evenly spread slices would lie more than 0.01 mm from their places; a tilt stays
  Linear,     ///< to a straight box of voxels, by linear interpolation
  Cubic,      ///< to a straight box of voxels, by cubic interpolation
  Off         ///< never: the slices are spread evenly between the first and the last
};

constexpr auto wordsOf(Regularise) {
  return std::to_array<Word<Regularise>>({{Regularise::Automatic, "auto"},
                                          {Regularise::Linear, "linear"},
                                          {Regularise::Cubic, "cubic"},
                                          {Regularise::Off, "off"}});
}

}  // namespace fenestra::io
