// A ray's walk over the volume, cell by cell (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing",
// 1987), with empty-space skipping: bricks of cells know the Chebyshev distance to the nearest brick that is not empty,
// and a ray crosses all that is empty around it in one step. First hits and both integrals walk by these rules.
//
// A walk always ends: each step moves on by at least one cell along one axis, and never back along any.
#include "lib/Ray.glsl"
#include "lib/Grid.glsl"

// The side of rendering/gpu/Bricks.h.
const int BRICK_SHIFT = 2, BRICK_SIDE = 1 << BRICK_SHIFT;

// What is empty around a cell: so many bricks up to the nearest that is not; or an octant of a brick; or nothing.
const int EMPTY_OCTANT = -1;

// `texel`: of the cell's brick (rendering/gpu/Bricks.h, skipTexels).
int emptyAround(uint texel, ivec3 cell) {
  int distance = int(texel & 255u);
  ivec3 octant = cell >> (BRICK_SHIFT - 1) & 1;
  uint shows = texel >> (8 + octant.x + 2 * octant.y + 4 * octant.z) & 1u;
  return distance > 0 || shows != 0u ? distance : EMPTY_OCTANT;
}

// What a ray crosses in one step: a cell, or what is empty around one.
struct Block {
  ivec3 cell, last;  // along each axis from the one, where the ray enters, to the other
  int empty;         // as of emptyAround(); 0: a single cell that may not be
};

// The face by which a ray leaves a block.
struct Face {
  ivec3 cell;    // the cell of the block that the ray leaves there
  ivec3 across;  // 1 on the face's axis, 0 on the others
  float s;       // mm along the ray
};

// 1 on axes along which the ray runs to higher indices.
ivec3 upwardsOf(Ray ray) { return ivec3(greaterThan(ray.direction, vec3(0.0))); }

ivec3 cellAt(Ray ray, float s) { return clamp(ivec3(floor(cellPosition(ray, s))), ivec3(0), volume.dims); }
bool isInVolume(ivec3 cell) { return all(lessThan(uvec3(cell), uvec3(volume.dims + 1))); }

// The block that begins in a cell. `empty`: around the cell.
Block blockAt(ivec3 cell, ivec3 upwards, int empty) {
  Block block;
  block.cell = cell;
  block.empty = empty;
  int shift = empty == EMPTY_OCTANT ? BRICK_SHIFT - 1 : BRICK_SHIFT;
  ivec3 end = ((cell >> shift) + abs(empty) * (2 * upwards - 1) + 1 - upwards << shift) - upwards;
  block.last = empty != 0 ? end : cell;
  return block;
}

// `s`: where the ray enters the block.
Face faceBehind(Block block, Ray ray, ivec3 upwards, float s) {
  vec3 planes = clamp(vec3(block.last + upwards), vec3(0.5), vec3(volume.dims) + 0.5);
  vec3 sides = mix((planes - ray.base) * ray.inverse, vec3(FAR), equal(ray.inverse, vec3(0.0)));
  Face face;
  face.s = max(min(sides.x, min(sides.y, sides.z)), s);
  bool x = sides.x <= sides.y && sides.x <= sides.z, y = !x && sides.y <= sides.z;
  bvec3 across = bvec3(x, y, !x && !y);
  face.across = ivec3(across);
  // Rounding must not carry the other two axes out of the block.
  ivec3 there = ivec3(cellPosition(ray, face.s));
  there = clamp(there, min(block.cell, block.last), max(block.cell, block.last));
  face.cell = mix(there, block.last, across);
  return face;
}

// The cell on the other side of a face; it may lie outside the volume.
ivec3 cellBehind(Face face, ivec3 upwards) { return face.cell + face.across * (2 * upwards - 1); }
