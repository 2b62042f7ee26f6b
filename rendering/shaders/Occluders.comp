// The medium that casts shadows, first step: the mean extinction of each cell as the volume is cut open.
// rendering/scene/Occlusion.h defines it. An invocation a cell: x, and y and z one below the other.
#include <clip>
#include <occluders>
#include <schedule>
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 4) readonly buffer OccluderCells { vec4 extinctions[]; };  // context, kept, exempt; 1/mm
layout(r32f) uniform writeonly image2D medium;                                      // 1/mm, a cell a texel, z below y

void main() {
  ivec2 at = regionPixel();
  if (at.x >= occluders.dims.x || at.y >= occluders.dims.y * occluders.dims.z) return;
  ivec3 cell = ivec3(at.x, at.y % occluders.dims.y, at.y / occluders.dims.y);
  int index = at.x + occluders.dims.x * at.y;
  vec3 extinction = extinctions[index].xyz;
  float sum = 0.0;
  if (extinction.x + extinction.y + extinction.z > 0.0) {
    for (int i = 0; i < 8; ++i) {
      vec3 place = vec3(cell) + vec3(0.2637, 0.2289, 0.2673) + 0.5 * vec3(i & 1, (i >> 1) & 1, i >> 2);
      float kept = keptShare(place * occluders.side + 0.5, occluders.width);
      sum += mix(extinction.z, visibleShare(place) * extinction.x + extinction.y, kept);
    }
  }
  imageStore(medium, at, vec4(0.125 * sum));
}
