// A pass may run over parts of the picture: gl::ShaderProgram::dispatch tells each its first pixel.

uniform ivec2 pixelOrigin;

// Groups are 8×8. Invocations that run in step, 8 or more of them in a row, take compact blocks of 4×2, 8×2, 8×4: rays
// that lie close by meet much the same.
ivec2 regionPixel() {
  int i = int(gl_LocalInvocationIndex);
  ivec2 within = ivec2((i & 3) | ((i >> 1) & 4), ((i >> 2) & 1) | ((i >> 3) & 6));
  return pixelOrigin + 8 * ivec2(gl_WorkGroupID.xy) + within;
}
