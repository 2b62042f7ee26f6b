// Another camera cuts the opening, which may hide a second stretch of a ray (RemovedParts.comp; the interface is described in
// None.glsl).

// Not an image, of which a shader may have eight.
uniform sampler2D hole;

const bool APART = true;

vec2 holeAt(ivec2 pixel) { return texelFetch(hole, pixel, 0).xy; }
