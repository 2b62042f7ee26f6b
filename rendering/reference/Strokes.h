#pragma once
// Brush strokes on the CPU in double precision: what rendering/settings/BrushStroke.h defines, line by line.

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

/// The effect of the strokes on every pixel, row by row from the top.
struct Edits {
  Image offset;  ///< mm that the ray start moved, negative towards the eye; 0 where the ray meets nothing
  Image factor;  ///< of the context layer's opacity where the ray meets the focus, of the border's elsewhere
  Image tStart;  ///< the ray start after the strokes; NaN where the ray meets nothing
};

/// `tStart` is stage 4's (rayStart), before any stroke.
Edits edits(const BrushStrokes& strokes, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
            const Image& tStart);
/// Edits of the rays through some places of the picture, one element each.
Edits edits(const BrushStrokes& strokes, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
            const Image& tStart, const std::vector<glm::dvec2>& places);

}  // namespace fenestra::reference
