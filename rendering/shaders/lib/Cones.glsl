// The depths that cones stand on: a pyramid of the greatest depth of squares of 2^level pixels a side, from CONE_TOP, the first
// ones, to single pixels, level 0, one level behind the other, row by row. Depths are mm behind the rays' anchor plane; -FAR where
// no cone stands. rendering/passes/ConePass.h has the formula.
#include <schedule>
#include "lib/None.glsl"
#include "lib/Uniforms.glsl"

layout(std430, binding = 0) buffer ConeDepths { float coneDepths[]; };

const int CONE_TOP = 8;

// Where a level begins that is so many below the top: the sum of 4^i top levels over those above it.
int coneLevel(int below) { return cones.tops.x * cones.tops.y * (0x5555 & ((1 << (2 * below)) - 1)); }
