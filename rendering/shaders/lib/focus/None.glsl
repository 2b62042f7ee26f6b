// No focus (the interface is described in Index.glsl).

const bool HAS_FOCUS = false;

struct FocusCell {
  uint none;
};

uint focusSlot(ivec3 cell) { return 0u; }
FocusCell focusCellAt(uint slot, ivec3 cell) { return FocusCell(0u); }
bool mayHoldFocus(FocusCell cell) { return false; }
float focusAt(FocusCell cell, vec3 within, float stored) { return 0.0; }
vec4 focusAlong(FocusCell cell, vec3 a, vec3 b, vec4 stored) { return vec4(0.0); }
vec2 focusRange() { return vec2(1.0, 0.0); }
