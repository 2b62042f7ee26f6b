// The second level of the reduction: one work group adds up the tiles of one view.
#include "lib/CandidateSums.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Ranges { uvec2 ranges[]; };  // first tile and tile count of each view
layout(std430, binding = 4) readonly buffer Partials { Sums partials[]; };
layout(std430, binding = 5) writeonly buffer Totals { Sums totals[]; };
uniform int viewCount;

void main() {
  uint view = gl_WorkGroupID.y * 1024u + gl_WorkGroupID.x;
  if (view >= uint(viewCount)) return;
  uint local = gl_LocalInvocationIndex;
  uvec2 range = ranges[view];
  Sums all = noSums();
  for (uint i = local; i < range.y; i += 64u) all = sumOf(all, partials[range.x + i]);
  all = sumOver(all, local, 64u);
  if (local == 0u) totals[view] = all;
}
