#pragma once
// What the cutaway of a view removes, on a slice.

#include <vector>

#include "rendering/settings/Camera.h"
#include "rendering/volume/Slice.h"

namespace fenestra {

/// Where the rays of a view's picture meet the context, and where they start to see; row by row from the top. t in mm
/// along the pixel's ray (see Camera), NaN where there is nothing.
struct RayStarts {
  Camera camera;
  Grid grid;  ///< of the volume in the picture
  glm::ivec2 size{0};
  std::vector<float> tContext, tStart;
};

/// 1 for each pixel of a slice, row by row, that the view's opening removes: it lies on its ray behind the context's
/// surface and before the ray's start. 0 elsewhere and outside the picture. Found at the nearest ray.
std::vector<char> openedPixels(const RayStarts& starts, const SliceGeometry& geometry, int slice);

}  // namespace fenestra
