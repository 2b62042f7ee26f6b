// The pixels of a picture that edges run through, and the rays between pixel centres that are drawn for them
// (rendering/scene/EdgeRays.h). A batch of the list's pixels is drawn at a time: each pixel has 2×2 invocations side by side.

layout(std430, binding = 7) buffer EdgeList {
  uint count;
  uint unused;
  uvec2 pixels[];  // x, with y in the upper half; the weight, bits of a float
} edgeList;

const int BLOCKS_ACROSS = 256;  // pixels of the list in a row; rendering/gpu/RayFrame.h

uniform int firstEdge, edgeCount;  // of the batch

ivec2 edgePixel(int edge) {
  uint both = edgeList.pixels[uint(firstEdge + clamp(edge, 0, edgeCount - 1))].x;
  return ivec2(both & 0xffffu, both >> 16);
}

// The pixel of the batch that an invocation belongs to; edgeCount or more: none.
int edgeOf(ivec2 invocation) { return (invocation.y >> 1) * BLOCKS_ACROSS + (invocation.x >> 1); }

// Where an invocation's ray runs through the picture, in pixels from its top left.
vec2 samplePlace(ivec2 invocation) {
  // A quarter turn from one offset to the next: the rotated grid.
  vec2 offset = vec2(0.4, 0.2);
  offset = (invocation.x & 1) == 1 ? vec2(-offset.y, offset.x) : offset;
  offset = (invocation.y & 1) == 1 ? -offset : offset;
  return vec2(edgePixel(edgeOf(invocation))) + 0.5 + offset;
}
