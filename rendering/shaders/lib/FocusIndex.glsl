// Where the focus is: a sparse index by bricks of cells. See rendering/gpu/FocusIndex.h.

#if FOCUS_KIND != 0
layout(r32ui) uniform readonly uimage3D focusBricks;   // 0: none of it, 1: all of the brick, n ≥ 2: slot n - 2 of focusCells
layout(std430, binding = 0) readonly buffer FocusCells { uint focusCells[]; };

const int CELLS_PER_BRICK = BRICK_SIDE * BRICK_SIDE * BRICK_SIDE;

uint focusSlot(ivec3 cell) { return imageLoad(focusBricks, cell >> BRICK_SHIFT).r; }

int cellInBrick(ivec3 cell) {
  ivec3 local = cell & (BRICK_SIDE - 1);
  return local.x + BRICK_SIDE * (local.y + BRICK_SIDE * local.z);
}
#endif

#if FOCUS_KIND == 1
// Labels: one byte a cell, bit i set when corner i (x fastest) is in the focus.
uint focusCorners(uint slot, ivec3 cell) {
  if (slot < 2u) return slot * 255u;
  int byte = int(slot - 2u) * CELLS_PER_BRICK + cellInBrick(cell);
  return (focusCells[byte >> 2] >> (8 * (byte & 3))) & 255u;
}

// Trilinear indicator, exact.
float focusIndicator(uint corners, vec3 w) {
  vec4 low = vec4(corners & 1u, (corners >> 2) & 1u, (corners >> 4) & 1u, (corners >> 6) & 1u);
  vec4 high = vec4((corners >> 1) & 1u, (corners >> 3) & 1u, (corners >> 5) & 1u, (corners >> 7) & 1u);
  vec4 x = mix(low, high, w.x);
  vec2 y = mix(x.xz, x.yw, w.y);
  return mix(y.x, y.y, w.z);
}
#elif FOCUS_KIND == 2
uniform float focusLow, focusHigh;  // stored values, closed interval

// Values: one bit a cell, set when it reaches into the range and belongs to a component that is kept.
bool focusCellKept(uint slot, ivec3 cell) {
  if (slot < 2u) return slot == 1u;
  int bit = int(slot - 2u) * CELLS_PER_BRICK + cellInBrick(cell);
  return ((focusCells[bit >> 5] >> (bit & 31)) & 1u) != 0u;
}
#endif
