#pragma once
// What the renderer and its reference share of a context that fades (MethodStages::Fading).

#include <optional>

#include "rendering/settings/Camera.h"
#include "rendering/vocabulary/MethodStages.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

struct Look;

/// How the context of a look's pictures fades; empty where it does not, the cutaway is off, or a ghost has no focus to
/// be in front of.
std::optional<MethodStages::Fading> fadingOf(const Look& look);
/// Whether it fades around a region that ends at a distance from the focus.
bool fadesByDistance(const Look& look);

/// The gradient (real values per mm) that counts as 1, and so does a steeper one: half of the range of the volume's
/// values over its finest spacing, the greatest difference along an axis that voxels of that spacing can have. 0 for a
/// volume of one value, whose gradients all count as 0.
double steepestSlope(const Volume& volume);

/// Where along a camera's rays the bounding sphere of a grid begins and ends, in mm from the eye, or from the plane of
/// the eye where rays are parallel; what lies behind the eye is left out. A sphere keeps both as they are while the
/// camera turns around the volume.
struct EyeRange {
  double nearest = 0.0, farthest = 0.0;
  /// d of rendering/methods/context-preserving/ContextPreserving.h at t mm along a ray; 0 where the whole sphere lies
  /// behind the eye.
  double distance(double t) const;
};
EyeRange eyeRangeOf(const Camera& camera, const Grid& grid);

}  // namespace fenestra
