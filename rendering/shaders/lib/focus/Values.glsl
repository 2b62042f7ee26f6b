// A focus of values: all points whose stored value lies in a range. The index holds one bit a cell, set when the cell
// reaches into the range and belongs to a component that is kept.
#include "lib/focus/Index.glsl"

struct FocusCell {
  uint kept;
};

FocusCell focusCellAt(uint slot, ivec3 cell) {
  if (slot < 2u) return FocusCell(slot);
  int bit = cellInSlot(slot, cell);
  return FocusCell((focusCells[bit >> 5] >> (bit & 31)) & 1u);
}

bool mayHoldFocus(FocusCell cell) { return cell.kept != 0u; }
float focusAt(FocusCell cell, vec3 within, float stored) { return stored; }
vec4 focusAlong(FocusCell cell, vec3 a, vec3 b, vec4 stored) { return stored; }
vec2 focusRange() { return focus.range; }
