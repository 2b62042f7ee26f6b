// No level of importance is lower.
//
// Level.glsl has the same interface; `#include <lower>` names the one that the level needs:
//   importantHits  the map of hits
//   orBelow        a ray's hit of the level, or where it misses the level, what it is opened to

layout(rg32f) uniform writeonly image2D importantHits;

float orBelow(float hit, ivec2 pixel) { return hit; }
