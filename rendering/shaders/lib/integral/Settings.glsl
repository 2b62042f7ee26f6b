// What both integrals read beside the volume: where nothing shows, and when a ray ends.
#include <schedule>
#include "lib/Traversal.glsl"
#include "lib/Uniforms.glsl"

// Where nothing shows, as emptyAround() reads it.
UNSIGNED_TEXELS_3D(r16ui, occupiedSkip);

// Where the look opens to labels of other levels of importance than the focus's, too (rendering/scene/Importance.h).
#ifndef IMPORTANCE_LEVELS
#define IMPORTANCE_LEVELS 0
#endif

// The focus's field where a ray starts on the focus's surface, on whichever side of it rounding has put the start. With
// IMPORTANCE_LEVELS the surface may be that of other labels, which have nothing to do with the focus.
float ontoFocus(float field, vec2 range) {
  float on = clamp(field, range.x, range.y);
#if IMPORTANCE_LEVELS
  const float ROUNDING = 1e-3;  // of an indicator of 0 to 1
  return abs(on - field) <= ROUNDING ? on : field;
#else
  return on;
#endif
}

int invisibleAround(ivec3 cell) { return emptyAround(texelOf(occupiedSkip, cell >> BRICK_SHIFT).r, cell); }

// A terminated ray loses up to leastTransmittance of its light. Half of it is added back in the ray's colour so far, which
// halves the largest error.
vec4 compensateTermination(vec4 result) { return result * (0.5 + 0.5 / result.a); }
