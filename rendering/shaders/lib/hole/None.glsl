// The picture's own camera cuts the opening: a ray that starts to see sees all that lies behind.
//
// Apart.glsl has the same interface; `#include <hole>` names the one that the picture needs:
//   APART   whether another camera cuts the opening
//   holeAt  from where to where a pixel's ray sees nothing again, mm
#include "lib/None.glsl"

const bool APART = false;

vec2 holeAt(ivec2 pixel) { return vec2(FAR); }
