// Stage 3, first step: the focus projection as one bit a pixel, 32 pixels of a row in a word.
layout(local_size_x = 8, local_size_y = 8) in;
layout(rg32f) uniform readonly image2D hitPoints;
layout(r32ui, binding = 0) uniform writeonly uimage2D focusMask;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(focusMask)))) return;
  int width = imageSize(hitPoints).x;
  uint word = 0u;
  for (int bit = 0; bit < 32; ++bit) {
    int x = at.x * 32 + bit;
    if (x < width && imageLoad(hitPoints, ivec2(x, at.y)).y > -1e29) word |= 1u << bit;
  }
  imageStore(focusMask, at, uvec4(word));
}
