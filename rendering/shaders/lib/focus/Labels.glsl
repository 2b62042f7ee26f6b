// A focus of labels: its surface is the 0.5 level of the trilinearly interpolated 0/1 indicator. The index holds one byte
// a cell, bit i set when corner i (x fastest) is in the focus.
#include "lib/focus/Index.glsl"
#include "lib/Crossing.glsl"

struct FocusCell {
  uint corners;
  ivec3 cell;  // of the grid that shaders walk
};

vec3 placeIn(FocusCell cell, vec3 within) { return withinVoxelCell(cell.cell, within); }

FocusCell focusCellAt(uint slot, ivec3 cell) {
  if (slot < 2u) return FocusCell(slot * 255u, cell);
  int byte = cellInSlot(slot, cell);
  return FocusCell((focusCells[byte >> 2] >> (8 * (byte & 3))) & 255u, cell);
}

bool mayHoldFocus(FocusCell cell) { return cell.corners != 0u; }

// The indicator, exact.
float focusAt(FocusCell cell, vec3 within, float stored) {
  uint c = cell.corners;
  vec4 low = vec4(c & 1u, (c >> 2) & 1u, (c >> 4) & 1u, (c >> 6) & 1u);
  vec4 high = vec4((c >> 1) & 1u, (c >> 3) & 1u, (c >> 5) & 1u, (c >> 7) & 1u);
  vec3 at = placeIn(cell, within);
  vec4 x = mix(low, high, at.x);
  vec2 y = mix(x.xz, x.yw, at.y);
  return mix(y.x, y.y, at.z);
}

vec4 focusAlong(FocusCell cell, vec3 a, vec3 b, vec4 stored) {
  float f[8];
  for (int i = 0; i < 8; ++i) f[i] = float((cell.corners >> i) & 1u);
  return bernsteinAlong(f, placeIn(cell, a), placeIn(cell, b));
}

vec2 focusRange() { return vec2(0.5, FAR); }
