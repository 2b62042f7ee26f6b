#pragma once
// How densely the integral along rays is sampled.

#include <cstdint>

namespace fenestra {

/// Draft and normal integrate the transfer function along each ray from one cell face to the next, and interpolate
/// between rays where the picture is smooth.
enum class Quality : std::uint8_t {
  Draft,   ///< while dragging: rays no closer than every other pixel, at least three times the tolerance for smooth
  Normal,  ///< rays closer together than the width of a voxel
  High,    ///< every ray, with an error of at most highQualityError
};
/// Error of a pixel's colour, in 1/255.
inline constexpr double highQualityError = 0.5;

}  // namespace fenestra
