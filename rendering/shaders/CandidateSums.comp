// The second level of the reduction: one work group adds up the tiles of one view.
layout(local_size_x = 64) in;
struct Sums {
  vec4 sums;
  vec4 more;
  ivec4 box;
};
layout(std430, binding = 3) readonly buffer Ranges { uvec2 ranges[]; };  // first tile and tile count of each view
layout(std430, binding = 4) readonly buffer Partials { Sums partials[]; };
layout(std430, binding = 5) writeonly buffer Totals { Sums totals[]; };
uniform int viewCount;

shared vec4 sums[64];
shared float backs[64];
shared ivec4 boxes[64];

void main() {
  uint view = gl_WorkGroupID.y * 1024u + gl_WorkGroupID.x;
  if (view >= uint(viewCount)) return;
  uint local = gl_LocalInvocationIndex;
  uvec2 range = ranges[view];
  vec4 sum = vec4(0.0);
  float back = 0.0;
  ivec4 box = ivec4(65535, 65535, -1, -1);
  for (uint i = local; i < range.y; i += 64u) {
    Sums part = partials[range.x + i];
    sum += part.sums;
    back += part.more.x;
    box = ivec4(min(box.xy, part.box.xy), max(box.zw, part.box.zw));
  }
  sums[local] = sum;
  backs[local] = back;
  boxes[local] = box;
  for (uint stride = 32u; stride > 0u; stride >>= 1) {
    barrier();
    if (local < stride) {
      sums[local] += sums[local + stride];
      backs[local] += backs[local + stride];
      boxes[local] = ivec4(min(boxes[local].xy, boxes[local + stride].xy), max(boxes[local].zw, boxes[local + stride].zw));
    }
  }
  if (local == 0u) {
    totals[view].sums = sums[0];
    totals[view].more = vec4(backs[0], 0.0, 0.0, 0.0);
    totals[view].box = boxes[0];
  }
}
