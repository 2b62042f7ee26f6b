// Rays run through the centres of pixels.
//
// Scattered.glsl has the same interface; `#include <places>` names the one that the picture needs:
//   SCATTERED  whether rays run between the centres of pixels
//   placeOf    where the ray of an invocation runs through the picture, in pixels from its top left
//   hasRay     whether an invocation has a ray
#include <schedule>
#include "lib/Uniforms.glsl"

const bool SCATTERED = false;

vec2 placeOf(ivec2 pixel) { return vec2(pixel) + 0.5; }
bool hasRay(ivec2 pixel) { return all(lessThan(pixel, rays.pictureSize)); }
