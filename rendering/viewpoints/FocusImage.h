#pragma once
// One candidate's image of the focus as plain data, and measures of its depths and its outline.

#include <vector>

#include <glm/glm.hpp>

namespace fenestra::placement {

/// First hits of parallel rays, and where the outline of the focus lies between them. Row by row from the top. Pixels
/// of the first and last row and column do not see the focus.
struct FocusImage {
  glm::ivec2 size{0};
  double pixel = 1.0;        ///< mm: a pixel's side
  std::vector<float> depth;  ///< mm along the view, from the plane through the model's centre; NaN: no focus
  /// Where one of a pixel and its right or lower neighbour sees the focus and the other does not: the part of the way
  /// to the neighbour at which the outline crosses, 0…1. Elsewhere it has no meaning.
  std::vector<float> right, below;

  bool sees(glm::ivec2 at) const;
  std::size_t offset(glm::ivec2 at) const {
    return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(at.x);
  }
};

/// The outline as closed polygons through its crossings, in pixels from the middle of the first pixel: marching squares
/// (Lorensen, Cline: Marching cubes. SIGGRAPH 1987, in two dimensions), where two pixels that see the focus across a
/// square's diagonal are connected. Outlines of holes are among them.
std::vector<std::vector<glm::dvec2>> outlinesOf(const FocusImage& image);

/// Sum of the outlines' lengths, mm.
double lengthOf(const std::vector<std::vector<glm::dvec2>>& outlines, double pixel);

/// ∫ |κ| ds over all outlines, radians: 2π for each that is convex. Without smoothing that would measure voxels and
/// pixels, so each outline is first cut into pieces of about a pixel and smoothed by a Gaussian of the standard
/// deviation `smoothing` (pixels, at least 2, as crossings are known to 1/32 of one); |κ| ds is the angle between
/// neighbouring pieces. Outlines shorter than 6 standard deviations, which that would shrink to a point, are left out.
double turningOf(const std::vector<std::vector<glm::dvec2>>& outlines, double smoothing);

/// Entropy in bits of the depths' histogram, of 32 equal bins from `nearest` to `farthest` (mm, as the depths); depths
/// beyond belong to the outermost bins. NaN where no pixel sees the focus.
double depthEntropy(const FocusImage& image, double nearest, double farthest);

}  // namespace fenestra::placement
