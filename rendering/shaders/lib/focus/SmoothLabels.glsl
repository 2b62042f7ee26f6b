// A focus of labels whose surface is smoothed: the 0.5 level of an indicator between 0 and 1 that is trilinear between the
// voxels (rendering/scene/SmoothedIndicator.h). In a brick that the surface crosses, the index holds the indicator at the
// corners of its cells; see FocusIndex::smoothedCells.
#include "lib/focus/Index.glsl"
#include "lib/Crossing.glsl"

struct FocusCell {
  vec4 low, high;  // the indicator at the corners on either side along x; y fastest
  ivec3 cell;  // of the grid that shaders walk
};

vec3 placeIn(FocusCell cell, vec3 within) { return withinVoxelCell(cell.cell, within); }

const int ROW_OF_PAIRS = BRICK_SIDE, LAYER_OF_PAIRS = BRICK_SIDE * (BRICK_SIDE + 1);

FocusCell focusCellAt(uint slot, ivec3 cell) {
  if (slot < 2u) return FocusCell(vec4(slot), vec4(slot), cell);
  ivec3 local = voxelCell(cell) & (BRICK_SIDE - 1);
  int at = int(slot - 2u) * LAYER_OF_PAIRS * (BRICK_SIDE + 1) + local.x + ROW_OF_PAIRS * local.y + LAYER_OF_PAIRS * local.z;
  vec2 a = unpackUnorm2x16(focusCells[at]), b = unpackUnorm2x16(focusCells[at + ROW_OF_PAIRS]),
       c = unpackUnorm2x16(focusCells[at + LAYER_OF_PAIRS]),
       d = unpackUnorm2x16(focusCells[at + LAYER_OF_PAIRS + ROW_OF_PAIRS]);
  return FocusCell(vec4(a.x, b.x, c.x, d.x), vec4(a.y, b.y, c.y, d.y), cell);
}

bool mayHoldFocus(FocusCell cell) {
  vec4 greatest = max(cell.low, cell.high);
  return max(max(greatest.x, greatest.y), max(greatest.z, greatest.w)) >= 0.5;
}

float focusAt(FocusCell cell, vec3 within, float stored) {
  vec3 at = placeIn(cell, within);
  vec4 x = mix(cell.low, cell.high, at.x);
  vec2 y = mix(x.xz, x.yw, at.y);
  return mix(y.x, y.y, at.z);
}

vec4 focusAlong(FocusCell cell, vec3 a, vec3 b, vec4 stored) {
  float f[8] = float[8](cell.low.x, cell.high.x, cell.low.y, cell.high.y, cell.low.z, cell.high.z, cell.low.w, cell.high.w);
  return bernsteinAlong(f, placeIn(cell, a), placeIn(cell, b));
}

vec2 focusRange() { return vec2(0.5, FAR); }
