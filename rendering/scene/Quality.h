#pragma once
// How the integral along rays is found.

#include <cstdint>

namespace fenestra {

/// Draft and normal interpolate between rays where voxels are larger than pixels and the picture is smooth.
enum class Quality : std::uint8_t {
  Draft,   ///< one sample per finest voxel: while dragging
  Normal,  ///< from face to face of the cells, the transfer function integrated between
  High,    ///< with an error of at most highQualityError
};
/// Of a pixel's colour, in 1/255.
inline constexpr double highQualityError = 0.5;

}  // namespace fenestra
