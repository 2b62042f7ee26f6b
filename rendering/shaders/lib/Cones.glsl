// The depths that cones stand on: a pyramid of the greatest depth of squares of 4^level pixels a side, from level 0, single
// pixels, to CONE_TOP, one level behind the other, row by row. Depths are mm behind the rays' anchor plane; -FAR where no cone
// stands. rendering/passes/ConePass.h has the formula.
#include <schedule>
#include "lib/None.glsl"

struct ConeSettings {
  ivec2 origin;    // pixel of the picture that the pyramid begins at
  ivec2 size;      // pixels, a multiple of the side of the top level's squares
  float slope;     // mm of depth per pixel beside the axis, on the anchor plane
  float perDepth;  // 1/mm, the reciprocal of the anchor plane's depth; 0 where rays are parallel
};
UNIFORM_BLOCK(ConeBlock, storedCones, ConeSettings, cones);

layout(std430, binding = 0) buffer ConeDepths { float coneDepths[]; };
