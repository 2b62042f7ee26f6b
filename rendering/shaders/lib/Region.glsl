// A pass may run over parts of the picture: gl::ShaderProgram::dispatch tells each its first pixel.

uniform ivec2 pixelOrigin;

// Groups are 8×8. Invocations that run in step, 8 or more of them in a row, take compact blocks of 4×2, 8×2, 8×4: rays
// that lie close by meet much the same.
ivec2 regionPixel() {
  int i = int(gl_LocalInvocationIndex);
  ivec2 within = ivec2((i & 3) | ((i >> 1) & 4), ((i >> 2) & 1) | ((i >> 3) & 6));
  return pixelOrigin + 8 * ivec2(gl_WorkGroupID.xy) + within;
}

// The same for every other pixel of a row, and the others of the next row: the i-th of `rows` pixels one below the other, in
// boxes of 2×rows pixels, in which the part's first one is counted. With one row, blocks hold 4×4, 8×4, 8×8 pixels.
ivec2 quincunxPixel(int rows, int i) {
  int k = int(gl_LocalInvocationIndex);
  ivec2 within = ivec2((k & 1) | ((k >> 2) & 2) | ((k >> 3) & 4), ((k >> 1) & 3) | ((k >> 2) & 4));
  ivec2 box = pixelOrigin + 8 * ivec2(gl_WorkGroupID.xy) + within;
  int row = rows * box.y + i;
  return ivec2(2 * box.x + (row & 1), row);
}
