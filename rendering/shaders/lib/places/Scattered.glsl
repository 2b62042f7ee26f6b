// Rays run between the centres of pixels, for smooth edges (rendering/scene/EdgeRays.h; the interface is described in
// Centres.glsl). An invocation's `pixel` is its own place in the images of such rays.
#include "lib/EdgeList.glsl"

const bool SCATTERED = true;

vec2 placeOf(ivec2 pixel) { return samplePlace(pixel); }
bool hasRay(ivec2 pixel) { return edgeOf(pixel) < edgeCount; }
