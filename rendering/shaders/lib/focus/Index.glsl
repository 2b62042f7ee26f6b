// Where the focus is: a sparse index by bricks of cells, see rendering/gpu/FocusIndex.h. Labels.glsl, SmoothLabels.glsl and
// Values.glsl say what it holds of a cell.
//
// These files and None.glsl share one interface; `#include <focus>` names the one that the scene needs:
//   HAS_FOCUS           false: there is none, and what stands behind it is never compiled
//   focusSlot           what the index says of a cell's brick; 0: none of the focus
//   FocusCell           what the index says of a cell
//   mayHoldFocus        false: none of the focus in the cell
//   focusAt, focusAlong the field at a point, and its Bernstein coefficients along a path, both within the cell
//   focusRange          the values of that field that are in the focus, closed
#include <schedule>
#include "lib/Traversal.glsl"
#include "lib/Uniforms.glsl"

UNSIGNED_TEXELS_3D(r32ui, focusBricks);  // 0: none of it, 1: all of the brick, n ≥ 2: slot n - 2 of focusCells
layout(std430, binding = 0) readonly buffer FocusCells { uint focusCells[]; };

const bool HAS_FOCUS = true;

const int CELLS_PER_BRICK = BRICK_SIDE * BRICK_SIDE * BRICK_SIDE;

uint focusSlot(ivec3 cell) { return texelOf(focusBricks, voxelCell(cell) >> BRICK_SHIFT).r; }

// Number of a cell in focusCells.
int cellInSlot(uint slot, ivec3 cell) {
  ivec3 local = voxelCell(cell) & (BRICK_SIDE - 1);
  return int(slot - 2u) * CELLS_PER_BRICK + local.x + BRICK_SIDE * (local.y + BRICK_SIDE * local.z);
}
