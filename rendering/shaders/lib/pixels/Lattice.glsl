// Rays run through every pitch-th pixel of every pitch-th row.
//
// Quincunx.glsl and Listed.glsl have the same interface; `#include <pixels>` names the one that the sampling needs:
//   pixelOf  the pixel of an invocation's i-th ray, of RAYS; it may lie outside of the picture
#include "lib/Region.glsl"

uniform int pitch;

// The rays of an invocation are those of pixels one below the other.
ivec2 pixelOf(int i) { return pitch * (regionPixel() * ivec2(1, RAYS) + ivec2(0, i)); }
