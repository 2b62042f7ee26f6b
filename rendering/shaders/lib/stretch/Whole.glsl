// A stretch of a ray of an exploded view is all that lies in a part.
//
// AtHit.glsl has the same interface; `#include <stretch>` names the one that the picture needs:
//   stretchOf  from where to where a pixel's ray may see, mm
#include "lib/None.glsl"

vec2 stretchOf(ivec2 pixel) { return vec2(-FAR, FAR); }
