#pragma once
// What a picture is made of, read back stage by stage.

#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

/// Row-major from the top of the picture; t in mm along the pixel's ray (see Camera), NaN where there is nothing.
/// Stages that the scene does not use are empty.
struct Layers {
  glm::ivec2 size{0};
  /// tFocus: with several levels of importance, of what the ray is opened to; see rendering/scene/Importance.h.
  std::vector<float> tContext, tFocus, tFocusFilled, tStart;
  std::vector<float> distance;            ///< px, 0 inside the focus projection (the opening, where cones cut
                                          ///< it), +inf beyond w_open + w_border
  std::vector<glm::vec2> edits;           ///< what strokes change, as EditMapPass has it
  std::vector<glm::vec4> focusLayer;      ///< premultiplied RGBA
  std::vector<glm::vec4> faintLayer;      ///< premultiplied RGBA of all that is removed, before it is made faint
  std::vector<glm::vec4> protectedLayer;  ///< premultiplied RGBA, in front of the focus layer
  std::vector<glm::vec4> contextLayer;    ///< κ1, κ2 (1/mm), illumination, value (real units)
  /// The context's first surface, where a lens reads it: its normal along the view's right, up and forward, 0 where
  /// there is none; mm to the lens's middle, NaN where there is no surface before the focus.
  std::vector<glm::vec4> lens;
  std::vector<glm::vec4> walls;  ///< premultiplied RGBA of slices that stand as walls, before they are laid
  std::vector<glm::vec4> final;  ///< premultiplied RGBA
};

}  // namespace fenestra
