#pragma once
// How far the steps of the voxels are smoothed away from the surface of labels in focus.

#include <cstdint>

namespace fenestra {

enum class LabelSmoothing : std::uint8_t {
  Off,     ///< the 0.5 level of the trilinearly interpolated 0/1 indicator
  Light,   ///< the 0.5 level of a SmoothedIndicator: steps of single voxels go
  Strong,  ///< more smoothing: terraces of several voxels go, too
};

}  // namespace fenestra
