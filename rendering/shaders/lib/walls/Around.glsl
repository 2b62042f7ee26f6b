// Walls stand around the volume, behind the picture.
//
// Inside.glsl has the same interface; `#include <walls>` names the one that the method needs:
//   spanOf    from where to where a pixel's ray may meet a wall, mm
//   withWall  a picture's colour with a wall's, premultiplied
#include "lib/None.glsl"
#include "lib/Uniforms.glsl"

vec2 spanOf(ivec2 pixel) { return vec2(-rays.distance, FAR); }
vec4 withWall(vec4 front, vec4 wall) { return front + (1.0 - front.a) * wall; }
