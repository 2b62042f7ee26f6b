#pragma once
// Smooth edges: which pixels of a picture several rays draw, and where those rays lie.
//
// A picture has a ray through the centre of each pixel. Where edges are smooth, P being that picture (premultiplied
// RGBA without background), pixel p becomes
//
//   (1 - w) P(p) + w mean(P(p), S(p, 1) … S(p, 4))
//
// S(p, i) is what a ray through p's centre plus sampleOffsets[i] shows; with the centre the five lie on a rotated grid,
// so that each is alone in a fifth of the pixel's width and in a fifth of its height. w grows from 0 to 1 between two
// contrasts: the greatest difference of a channel between p and one of the four pixels beside it. It counts `outline`
// times where the rays of the two do not meet the same (context, focus, neither): there an outline runs between them.
// The line around an opening is smooth by itself: where it covers a part of one of two pixels whose rays meet the same,
// they count as alike. Only a picture with an opening knows what its rays meet.
//
// On a ray off the centres stages 1, 5, 6 and 7 are what they are on any other. The opening is that of the pixels: the
// distance map, as far as it matters (w_open + w_border + distanceBeyond, beyond which it is constant), and the filled
// focus are interpolated bilinearly between the centres; a cut face has the normal that it has in the pixel; the line
// around the opening covers the share of a box as wide as a fifth of a pixel, and none of a ray that meets the focus.
// Where another camera cuts the opening, stage 4 of a ray is defined without the picture's pixels.

#include <algorithm>
#include <array>

#include <glm/glm.hpp>

namespace fenestra::edges {

/// In pixels, from a pixel's centre; y downwards.
inline constexpr std::array<glm::dvec2, 4> sampleOffsets{
    {glm::dvec2(0.4, 0.2), glm::dvec2(-0.2, 0.4), glm::dvec2(-0.4, -0.2), glm::dvec2(0.2, -0.4)}};
/// Width in pixels of the box that stands for a sample.
inline constexpr double sampleWidth = 0.2;
/// Contrasts of a channel, 0..1, at which w begins to grow and reaches 1. A scan's texture is full of smaller steps,
/// and each pixel with w > 0 costs four rays.
inline constexpr double leastContrast = 64.0 / 255.0, fullContrast = 96.0 / 255.0;
inline constexpr double outline = 2.0;
/// Pixels: between two of them, and a little more.
inline constexpr double distanceBeyond = 2.0;

/// w of a pixel with that contrast.
inline double weight(double contrast) {
  return std::clamp((contrast - leastContrast) / (fullContrast - leastContrast), 0.0, 1.0);
}

}  // namespace fenestra::edges
