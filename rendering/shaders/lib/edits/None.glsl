// No brush stroke has moved anything.
//
// Map.glsl has the same interface; `#include <edits>` names the one that the picture needs:
//   EDITED  whether there are strokes
//   editAt  what strokes have done to a pixel's ray, as EditMap.comp writes it: how far they moved its start, mm; and the
//           factor of the context layer's opacity, or of the border's

const bool EDITED = false;

vec2 editAt(ivec2 pixel) { return vec2(0.0, 1.0); }
