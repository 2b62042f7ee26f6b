#pragma once
// Pictures along a curve: straightened, and across it.

#include <vector>

#include "rendering/reformat/PathCurve.h"
#include "rendering/volume/Slice.h"

namespace fenestra::reformat {

/// Row by row from the top, which is the curve's beginning; the curve runs down the middle.
struct StraightPicture {
  int width = 0, height = 0;
  double spacing = 1.0;       ///< mm from pixel to pixel: down along the curve, and to the right across it
  std::vector<float> values;  ///< real, trilinear; NaN outside the volume
};

/// Pixels a side, with which a picture would be larger than any use.
inline constexpr int largestStraightPicture = 16384;

/// The volume along the curve: row j lies j·spacing mm from its beginning, across the curve in the direction that
/// `angle` (radians) turns the frame's right towards its up. `width` in mm. Sides of more than largestStraightPicture
/// pixels are a programmer's error. Runs on all cores.
StraightPicture straightened(const Volume& volume, const PathCurve& curve, double spacing, double width, double angle);

/// One slice across the curve, about its place `mm` from the beginning: seen along the curve, the frame's right, turned
/// by `angle`, to the right, and its up downwards, so that it is no mirror image. `width` mm each way.
SliceGeometry crossSection(const PathCurve& curve, double mm, double spacing, double width, double angle);

}  // namespace fenestra::reformat
