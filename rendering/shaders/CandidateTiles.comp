// First focus hits of many candidate cameras: a work group is one 8×8 tile of one candidate's image, reduced to its sums.
#include "lib/Ray.glsl"
#include "lib/Volume.glsl"
#include "lib/Crossing.glsl"
#include "lib/FocusIndex.glsl"
#include "lib/FirstHit.glsl"
#include "lib/Candidate.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 3) readonly buffer Tiles { uvec2 tiles[]; };  // candidate; tile column | tile row << 16
struct Sums {
  vec4 sums;   // count, depth, x, y
  ivec4 box;   // x0, y0, x1, y1
};
layout(std430, binding = 4) writeonly buffer Partials { Sums partials[]; };
uniform int tileCount;
uniform int side;            // pixels of a candidate's image

shared vec4 sums[64];
shared ivec4 boxes[64];

void main() {
  // A row of groups holds 1024 tiles: one dimension alone would end at 65535.
  uint tile = gl_WorkGroupID.y * 1024u + gl_WorkGroupID.x;
  if (tile >= uint(tileCount)) return;
  uint local = gl_LocalInvocationIndex;
  ivec2 pixel = ivec2(tiles[tile].y & 0xffffu, tiles[tile].y >> 16) * 8 + ivec2(gl_LocalInvocationID.xy);
  vec2 position = 2.0 * (vec2(pixel) + 0.5) / float(side) - 1.0;
  position.y = -position.y;
  sums[local] = vec4(0.0);
  boxes[local] = ivec4(side, side, -1, -1);
  if (all(lessThan(pixel, ivec2(side)))) {
    Ray ray = candidateRay(tiles[tile].x, position);
    float hit = ray.sIn <= ray.sOut ? firstFocusHit(ray) : NONE;
    if (!isNone(hit)) {
      sums[local] = vec4(1.0, 0.5 + 0.5 * hit / sphereRadius, position);
      boxes[local] = ivec4(pixel, pixel);
    }
  }
  // A tree of fixed shape: the same sums whatever runs first.
  for (uint stride = 32u; stride > 0u; stride >>= 1) {
    barrier();
    if (local < stride) {
      sums[local] += sums[local + stride];
      boxes[local] = ivec4(min(boxes[local].xy, boxes[local + stride].xy), max(boxes[local].zw, boxes[local + stride].zw));
    }
  }
  if (local == 0u) {
    partials[tile].sums = sums[0];
    partials[tile].box = boxes[0];
  }
}
