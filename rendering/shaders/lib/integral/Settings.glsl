// What both integrals read beside the volume: where nothing shows, and when a ray ends.
#include <importance>
#include <schedule>
#include "lib/Traversal.glsl"
#include "lib/Uniforms.glsl"

const bool FOCUS_BY_VALUE = FOCUS_FUNCTIONS == 1;  // some of the focus is shown by a function of the value

// Where nothing shows, as emptyAround() reads it.
UNSIGNED_TEXELS_3D(r16ui, occupiedSkip);

int invisibleAround(ivec3 cell) { return emptyAround(texelOf(occupiedSkip, cell >> BRICK_SHIFT).r, cell); }

// A terminated ray loses up to leastTransmittance of its light. Half of it is added back in the ray's colour so far, which
// halves the largest error.
vec4 compensateTermination(vec4 result) { return result * (0.5 + 0.5 / result.a); }
