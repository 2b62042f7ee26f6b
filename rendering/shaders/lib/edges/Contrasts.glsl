// What both alternatives of `<edges>` read.
uniform vec2 contrasts;

float highest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }
