// What a candidate image shows of the focus, and its sum over neighbouring invocations.
#include <ends>

struct Sums {
  vec4 sums;   // area in pixels; depth from the front times area; position times area
  vec4 more;   // x: depth from behind times area; with END_FACES y, z: area through end faces from the front, from behind
  ivec4 box;   // x0, y0, x1, y1 of the pixels that see the focus
};

Sums noSums() { return Sums(vec4(0.0), vec4(0.0), ivec4(65535, 65535, -1, -1)); }

Sums sumOf(Sums a, Sums b) {
  return Sums(a.sums + b.sums, a.more + b.more, ivec4(min(a.box.xy, b.box.xy), max(a.box.zw, b.box.zw)));
}

shared vec4 sharedSums[64];
shared ivec4 sharedBoxes[64];

// The sum over the `count` invocations of which this one is the lane-th, a power of two; valid in lane 0. Called by all 64
// invocations of a group. A tree of fixed shape: the same rounding whatever runs first.
Sums sumOver(Sums mine, uint lane, uint count) {
  uint local = gl_LocalInvocationIndex;
  for (uint stride = count >> 1; stride > 0u; stride >>= 1) {
    sharedSums[local] = mine.sums;
    sharedMore[local] = storedMore(mine.more);
    sharedBoxes[local] = mine.box;
    barrier();
    if (lane < stride) {
      uint other = local + stride;
      mine = sumOf(mine, Sums(sharedSums[other], restoredMore(sharedMore[other]), sharedBoxes[other]));
    }
    barrier();
  }
  return mine;
}
