// Labels in focus have materials or functions of their own: a point looks like its nearest voxel (the interface is described
// in None.glsl).
#include "lib/Grid.glsl"
#include "lib/Uniforms.glsl"
#include "lib/integral/Bodies.glsl"

const bool MANY_COLOURS = true;

uniform usampler3D focusPaletteIndex;
uniform sampler2D focusPalette;  // a row of colours and opacities, and with functions one of their tables

uint paletteEntry(vec3 at) {
  return texelFetch(focusPaletteIndex, ivec3(floor(voxelPosition(at) - 0.5)) - focus.paletteOrigin, 0).r;
}

vec4 focusMaterial(vec3 at) {
  vec4 colour = texelFetch(focusPalette, ivec2(paletteEntry(at), 0), 0);
  return vec4(colour.rgb, 1.0) * focus.material.a;
}
Label focusLabel(vec3 at) {
  int entry = int(paletteEntry(at));
  float opacity = texelFetch(focusPalette, ivec2(entry, 0), 0).a;
  return opacity < 1.0 ? Label(FOCUS_LABELS + entry, opacity) : noLabel();
}
vec4 focusTable(vec3 at) { return texelFetch(focusPalette, ivec2(paletteEntry(at), 1), 0); }
float nextColour(vec3 a, vec3 b, float u) { return nextNearest(a, b, u); }
