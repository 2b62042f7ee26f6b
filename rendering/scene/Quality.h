#pragma once
// How finely rays are sampled.

#include <cstdint>

namespace fenestra {

enum class Quality : std::uint8_t {
  Draft,   ///< one sample per finest voxel: while dragging
  Normal,  ///< two
  High,    ///< as many as an error of at most highQualityError asks for
};
/// Of a pixel's colour, in 1/255.
inline constexpr double highQualityError = 0.5;

}  // namespace fenestra
