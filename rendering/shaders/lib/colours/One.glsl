// All of the focus has one material or function (the interface is described in None.glsl).
#include "lib/Uniforms.glsl"
#include "lib/integral/Bodies.glsl"

const bool MANY_COLOURS = false;

vec4 focusMaterial(vec3 at) { return vec4(focus.material.rgb, 1.0) * focus.material.a; }
Label focusLabel(vec3 at) { return Label(FOCUS_LABELS, focus.table.w); }
vec4 focusTable(vec3 at) { return focus.table; }
float nextColour(vec3 a, vec3 b, float u) { return 1.0; }
