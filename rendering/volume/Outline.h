#pragma once
// The outline of a part of a slice as smooth lines, so that it does not show the voxels' steps.

#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

/// Closed lines around the pixels whose `inside` is not 0, row by row, width·height of them; pixel centres on whole
/// numbers, (0, 0) at the top left. A line passes between the centres of pixels inside and outside: marching squares
/// (Lorensen, Cline, "Marching Cubes", SIGGRAPH 1987, in the plane), then smoothed by Taubin's filter ("A Signal
/// Processing Approach to Fair Surface Design", SIGGRAPH 1995), which does not shrink it. No point moves by more than
/// half a pixel, so that thin parts stay and holes do not close.
std::vector<std::vector<glm::dvec2>> smoothOutlines(const std::vector<char>& inside, int width, int height);

}  // namespace fenestra
