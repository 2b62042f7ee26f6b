// The edges of what was removed do not show.
//
// Edges.glsl has the same interface; `#include <contextLayer>` names the one that the look needs:
//   withContextLayer  a pixel's colour, premultiplied, behind the context layer. `hit`: context and focus hit; `share`: of what
//                     the opening removes, as `<faint>` has it

vec4 withContextLayer(vec4 result, ivec2 pixel, vec2 hit, float share) { return result; }
