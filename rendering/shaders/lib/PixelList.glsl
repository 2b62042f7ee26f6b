// The pixels that still need a ray, in rows of work groups as glDispatchComputeIndirect takes them. Each of the 64
// invocations of a group traces RAYS of them.

const uint GROUP_SIZE = 64u * uint(RAYS), ROW_SIZE = 16u * GROUP_SIZE;  // pixels

layout(std430, binding = 2) buffer PixelList {
  uint groups[3];  // in a row; rows; 1
  uint count;
  uint pixels[];   // y in the upper half
};

void enlist(bvec2 which, ivec2 first, ivec2 second) {
  uint added = uint(which.x) + uint(which.y);
  if (added == 0u) return;
  uint at = atomicAdd(count, added);
  uint rows = (at + added + ROW_SIZE - 1u) / ROW_SIZE - (at + ROW_SIZE - 1u) / ROW_SIZE;
  if (rows > 0u) atomicAdd(groups[1], rows);
  if (which.x) pixels[at++] = uint(first.x | first.y << 16);
  if (which.y) pixels[at] = uint(second.x | second.y << 16);
}

// The i-th pixel of this invocation; a pixel outside of every picture when the list has ended.
ivec2 listedPixel(int i) {
  uint at = gl_WorkGroupID.y * ROW_SIZE + gl_WorkGroupID.x * GROUP_SIZE;
  at += gl_LocalInvocationIndex * uint(RAYS) + uint(i);
  return at < count ? ivec2(pixels[at] & 0xffffu, pixels[at] >> 16) : ivec2(0xffff);
}
