#pragma once
// How the integral along rays is found.

#include <cstdint>

namespace fenestra {

/// Draft and normal go along rays from face to face of the cells, the transfer function integrated between, and
/// interpolate between rays where the picture is smooth.
enum class Quality : std::uint8_t {
  Draft,   ///< rays two pixels apart at least, and three times as much taken for smooth: while dragging
  Normal,  ///< rays closer than voxels are wide
  High,    ///< every ray, with an error of at most highQualityError
};
/// Of a pixel's colour, in 1/255.
inline constexpr double highQualityError = 0.5;

}  // namespace fenestra
