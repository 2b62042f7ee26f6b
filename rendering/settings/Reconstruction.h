#pragma once
// How 3-D pictures reconstruct the values between the voxels.

#include <cstdint>

namespace fenestra {

enum class Reconstruction : std::uint8_t {
  Linear,  ///< trilinear
  Cubic,   ///< the tricubic spline through the voxels' values, see SplineVolume
  Smooth,  ///< the tricubic B-spline over the values, which smooths them
  /// Smooth, over means of the values: the skin in CT of 3 mm shows no terraces any more, but thin structures fade.
  Smoother,
  /// Smooth or Smoother where a volume is coarse and small enough, see reconstructionOf(); else Linear. Not Cubic: it
  /// keeps the noise of a scan, and rings at edges that are sharper than the voxels, as the skin is in coarse CT.
  Auto
};

}  // namespace fenestra
