// Normals and slopes along a path through a cell of trilinear values.
#include <fading>
#include <light>
#include <normals>
#include <volume>
#include "lib/Crossing.glsl"
#include "lib/integral/PathLight.glsl"

// Central difference along an axis at corner i of a cell, from the cell's corners and the voxel beyond; one-sided at the
// volume's border.
float differenceAt(float inner[8], ivec3 cell, int i, int axis) {
  int across = i ^ (1 << axis);
  bool isUpper = across < i;
  ivec3 corner = cell - 1 + cornerOf(i), step = ivec3(axis == 0, axis == 1, axis == 2);
  float outer = storedAt(corner + (isUpper ? step : -step));
  bool isBorder = isUpper ? corner[axis] >= volume.dims[axis] - 1 : corner[axis] <= 0;
  return (isUpper ? outer - inner[across] : inner[across] - outer) * (isBorder ? 1.0 : 0.5);
}

// Central differences at the corners of a cell, `f`. What lies beyond the outermost voxels has the gradient of those: there it
// takes the cell beside, and moves the ends to its face.
void slopesAround(ivec3 cell, inout vec3 a, inout vec3 b, out vec3 f[8]) {
  ivec3 inside = clamp(cell, ivec3(1), max(volume.dims - 1, ivec3(1)));
  vec3 moved = vec3(cell - inside);
  a = clamp(a + moved, 0.0, 1.0);
  b = clamp(b + moved, 0.0, 1.0);
  float inner[8];
  cellCorners(inside, inner);
  for (int i = 0; i < 8; ++i)
    f[i] = slopeFromIndex() * vec3(differenceAt(inner, inside, i, 0), differenceAt(inner, inside, i, 1),
                                   differenceAt(inner, inside, i, 2));
}

Slopes slopesAlong(ivec3 cell, inout vec3 a, inout vec3 b, out vec3 f[8]) {
  Slopes slopes;
  slopes.outside = outsideAlong(cell, a, b);
  slopesAround(cell, a, b, f);
  bernsteinAlong(f, a, b, slopes.along);
  return slopes;
}

// `a` and `b`: the path's ends within the cell.
CellNormals normalsAlong(ivec3 cell, vec3 a, vec3 b) {
  vec3 f[8];
  CellNormals normals;
  if (FADES) {
    normals.slopes = slopesAlong(cell, a, b, f);
    if (LIT)
      for (int i = 0; i < 8; ++i) f[i] = gatedSlope(f[i]);
  } else {
    for (int i = 0; i < 8; ++i) f[i] = gatedAt(cell - 1 + cornerOf(i));
  }
  bernsteinAlong(f, a, b, normals.gated);
  return normals;
}
