#pragma once
// How finely rays are sampled.

#include <cstdint>

namespace fenestra {

enum class Quality : std::uint8_t {
  Draft,   ///< one sample per finest voxel: while dragging
  Normal,  ///< two
  High,    ///< four
};

}  // namespace fenestra
