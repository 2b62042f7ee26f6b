// The tiles of 8×8 pixels that candidate images are cut into: only those that the focus can lie in.

struct Tile {
  uint view;
  int x, y;         // first pixel, from the top left of the image; may lie outside it by a tile
  uint neighbours;  // bit 0: the next tile is the right neighbour; the rest: how many tiles on the one below is, or 0
};
layout(std430, binding = 3) readonly buffer Tiles { Tile tiles[]; };
uniform int tileCount;
uniform int side;   // pixels of an image

// A row of work groups holds 1024 tiles: one dimension alone would end at 65535.
uint tileOfGroup() { return gl_WorkGroupID.y * 1024u + gl_WorkGroupID.x; }

// -1…1 across the image, y upwards, of a pixel's middle.
vec2 imagePosition(vec2 pixel) {
  vec2 position = 2.0 * (pixel + 0.5) / float(side) - 1.0;
  return vec2(position.x, -position.y);
}
