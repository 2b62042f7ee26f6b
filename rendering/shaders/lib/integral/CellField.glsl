// The values and the gated normals at the corners of a cell, read once for all points in it.
#include <normals>
#include <volume>

struct CellField {
  vec4 low, high;  // texels at the lower and at the upper x, counted as cornerOf() counts
  vec3 gated[8];
};

CellField fieldOf(ivec3 cell) {
  ivec3 low = max(cell - 1, ivec3(0)), high = min(cell, volume.dims - 1);
  CellField field;
  float texels[8];
  for (int i = 0; i < 8; ++i) {
    ivec3 voxel = mix(low, high, bvec3(cornerOf(i)));
    texels[i] = texelOf(volumeTexels, voxel).r;
    field.gated[i] = gatedAt(voxel);
  }
  field.low = vec4(texels[0], texels[2], texels[4], texels[6]);
  field.high = vec4(texels[1], texels[3], texels[5], texels[7]);
  return field;
}

// Trilinear at `w`, a position within the cell.
float storedIn(CellField field, vec3 w) {
  vec4 x = mix(field.low, field.high, w.x);
  vec2 y = mix(x.xz, x.yw, w.y);
  return TEXEL_SCALE * mix(y.x, y.y, w.z);
}

vec3 gatedIn(CellField field, vec3 w) {
  vec3 low = mix(mix(field.gated[0], field.gated[1], w.x), mix(field.gated[2], field.gated[3], w.x), w.y);
  vec3 high = mix(mix(field.gated[4], field.gated[5], w.x), mix(field.gated[6], field.gated[7], w.x), w.y);
  return mix(low, high, w.z);
}
