// Cones stand on one level of importance, that of the focus.
//
// Lowest.glsl and Higher.glsl have the same interface; `#include <level>` names the one that the level needs:
//   storeStart  stores where a ray starts to see. `hit`: its context hit, and that of what cones stand on
layout(r32f) uniform writeonly image2D coneStart;

void storeStart(ivec2 pixel, vec2 hit, float start) { imageStore(coneStart, pixel, vec4(start)); }
