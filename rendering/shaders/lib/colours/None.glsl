// No focus to be seen.
//
// One.glsl and Palette.glsl have the same interface; `#include <colours>` names the one that the scene needs:
//   focusMaterial  colour · extinction and extinction (1/mm) of the focus at a position (cell frame)
//   focusLabel     the translucent label there (lib/integral/Bodies.glsl)
//   focusTable     with FOCUS_FUNCTIONS, where some of the focus is shown by value: the first row of its function in
//                  lib/Transfer.glsl's tables, and entry = stored value · y + z there; 0 where it is of one material
//   nextColour     where after u the material or function changes along a path within a cell
//   MANY_COLOURS   whether it ever does
#include "lib/integral/Bodies.glsl"

const bool MANY_COLOURS = false;

vec4 focusMaterial(vec3 at) { return vec4(0.0); }
Label focusLabel(vec3 at) { return noLabel(); }
vec4 focusTable(vec3 at) { return vec4(0.0); }
float nextColour(vec3 a, vec3 b, float u) { return 1.0; }
