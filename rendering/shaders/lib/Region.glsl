// A pass may run over parts of the picture: gl::ShaderProgram::dispatch tells each its first pixel.

uniform ivec2 pixelOrigin;

// The group's place in the part. llvmpipe gives each of its threads one run of groups, row by row. Rows are taken in steps of
// STRIDE, so that each run is spread over the picture: no thread waits for the one whose rows show most of the body.
ivec2 groupPlace() {
  const int STRIDE = 4;
  int rows = int(gl_NumWorkGroups.y), row = int(gl_WorkGroupID.y);
  int each = rows / STRIDE, longer = rows % STRIDE, behind = row - longer * (each + 1);
  int first = behind < 0 ? row / (each + 1) : longer + behind / max(each, 1);
  int along = behind < 0 ? row % (each + 1) : behind % max(each, 1);
  return ivec2(gl_WorkGroupID.x, first + STRIDE * along);
}

// Groups are 8×8. Invocations that run in step, 8 or more of them in a row, take compact blocks of 4×2, 8×2, 8×4: rays
// that lie close by meet much the same.
ivec2 regionPixel() {
  int i = int(gl_LocalInvocationIndex);
  ivec2 within = ivec2((i & 3) | ((i >> 1) & 4), ((i >> 2) & 1) | ((i >> 3) & 6));
  return pixelOrigin + 8 * groupPlace() + within;
}

// A pixel of a quincunx: every other pixel of a row, and in the next row the others. The part is counted in boxes 2 pixels
// wide and `rows` high; an invocation has one pixel in each row of its box, and this is the i-th. With one row, invocations
// that run in step have blocks of 4×4, 8×4 or 8×8 pixels.
ivec2 quincunxPixel(int rows, int i) {
  int k = int(gl_LocalInvocationIndex);
  ivec2 within = ivec2((k & 1) | ((k >> 2) & 2) | ((k >> 3) & 4), ((k >> 1) & 3) | ((k >> 2) & 4));
  ivec2 box = pixelOrigin + 8 * groupPlace() + within;
  int row = rows * box.y + i;
  return ivec2(2 * box.x + (row & 1), row);
}
