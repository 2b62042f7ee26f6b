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

// Pixels are numbered tile by tile. Edges run from a pixel's middle to the next one's on the right, or below: edge
// 2·pixel, or 2·pixel + 1.
const uint NOWHERE = 0xffffffffu;

// The pixel at (x, y) of a tile, or one beyond it to the right and below, in the neighbouring tile.
uint pixelOf(uint tile, ivec2 at) {
  uint links = tiles[tile].neighbours;
  if (at.x == 8) {
    if ((links & 1u) == 0u) return NOWHERE;
    tile += 1u;
  }
  if (at.y == 8) {
    if (links >> 1 == 0u) return NOWHERE;
    tile += links >> 1;
  }
  return 64u * tile + uint((at.y & 7) * 8 + (at.x & 7));
}

// In the image, from the top left.
ivec2 placeOf(uint pixel) {
  Tile tile = tiles[pixel >> 6];
  return ivec2(tile.x, tile.y) + ivec2(pixel & 7u, (pixel >> 3) & 7u);
}

// -1…1 across the image, y upwards, of a pixel's middle.
vec2 imagePosition(vec2 pixel) {
  vec2 position = 2.0 * (pixel + 0.5) / float(side) - 1.0;
  return vec2(position.x, -position.y);
}
