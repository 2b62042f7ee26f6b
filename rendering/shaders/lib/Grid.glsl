// The volume's grid. Cell c of the cell frame (see lib/Ray.glsl) exists for 0 ≤ c ≤ dims. What belongs to the voxels, such as
// the focus, lies in cells of the voxels' own grid, which `<grid>` finds.
#include <schedule>
#include <grid>
#include "lib/Uniforms.glsl"

// Corners of a cell are counted x fastest.
ivec3 cornerOf(int i) { return ivec3(i & 1, (i >> 1) & 1, i >> 2); }

// The first u' > u, at most 1, where from a to b, both within a cell (0 to 1), another voxel becomes the nearest: half way
// between voxel centres, which is in the middle of cells of a finer grid, too.
float nextNearest(vec3 a, vec3 b, float u) {
  vec3 at = (0.5 - a) / (b - a);
  at = mix(vec3(1.0), at, greaterThan(at, vec3(u)));
  return min(min(at.x, at.y), min(at.z, 1.0));
}
