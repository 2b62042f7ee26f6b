// The depths that cones stand on: a pyramid of the greatest depth of squares of 2^level pixels a side, from CONE_TOP, the first
// ones, to single pixels, level 0, one level behind the other, row by row. Depths are mm behind the rays' anchor plane; -FAR where
// no cone stands. rendering/passes/ConePass.h has the formula.
#include <schedule>
#include "lib/None.glsl"

struct ConeSettings {
  ivec2 origin;    // pixel of the picture that the pyramid begins at
  ivec2 tops;      // squares of the top level
  float slope;     // mm of depth per pixel beside the axis, on the anchor plane
  float perDepth;  // 1/mm, the reciprocal of the anchor plane's depth; 0 where rays are parallel
};
UNIFORM_BLOCK(ConeBlock, storedCones, ConeSettings, cones);

layout(std430, binding = 0) buffer ConeDepths { float coneDepths[]; };

const int CONE_TOP = 8;

// Where a level begins that is so many below the top: the sum of 4^i top levels over those above it.
int coneLevel(int below) { return cones.tops.x * cones.tops.y * (0x5555 & ((1 << (2 * below)) - 1)); }
