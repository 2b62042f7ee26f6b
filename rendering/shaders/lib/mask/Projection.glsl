// The mask is the focus's projection.
//
// Opening.glsl has the same interface; `#include <mask>` names the one that the method needs:
//   isInside  whether a pixel belongs to the mask. `hit`: context and focus hit of its ray
#include "lib/None.glsl"

bool isInside(ivec2 pixel, vec2 hit) { return !isNone(hit.y); }
