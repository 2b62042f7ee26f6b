// What both integrals read beside the volume: where nothing shows, and when a ray ends.
#include <schedule>
#include "lib/Traversal.glsl"

// Chebyshev distance in bricks to the nearest one that shows anything.
UNSIGNED_TEXELS_3D(r8ui, occupiedSkip);

struct IntegralSettings {
  float leastTransmittance;  // early ray termination: what lies behind less than that does not show
  float maxError;            // of a pixel's colour; for lib/integral/CellByCell.glsl
};
UNIFORM_BLOCK(IntegralBlock, storedIntegral, IntegralSettings, integral);

int distanceToVisible(ivec3 cell) { return int(texelOf(occupiedSkip, cell >> BRICK_SHIFT).r); }

// A terminated ray loses up to leastTransmittance of its light. Half of it is added back in the ray's colour so far, which
// halves the largest error.
vec4 compensateTermination(vec4 result) { return result * (0.5 + 0.5 / result.a); }
