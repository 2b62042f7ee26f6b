// What labels in focus look like, by the nearest voxel: a part of Labels.glsl and SmoothLabels.glsl, which include it
// after Index.glsl.
vec2 focusRange() { return vec2(0.5, FAR); }

#if FOCUS_PALETTE
uniform usampler3D focusPaletteIndex;
uniform sampler2D focusPalette;  // a row of colours and shares of the extinction, and with functions one of their tables

// Of the nearest voxel.
uint paletteEntry(vec3 at) {
  return texelFetch(focusPaletteIndex, ivec3(floor(voxelPosition(at) - 0.5)) - focus.paletteOrigin, 0).r;
}

vec4 focusMaterial(vec3 at) {
  vec4 colour = texelFetch(focusPalette, ivec2(paletteEntry(at), 0), 0);
  return vec4(colour.rgb, 1.0) * (colour.a * focus.material.a);
}
vec4 focusTable(vec3 at) { return texelFetch(focusPalette, ivec2(paletteEntry(at), 1), 0); }

// The nearest voxel tells the colour.
float nextColour(vec3 a, vec3 b, float u) { return nextNearest(a, b, u); }
#else
vec4 focusMaterial(vec3 at) { return vec4(focus.material.rgb, 1.0) * focus.material.a; }
vec4 focusTable(vec3 at) { return focus.table; }
float nextColour(vec3 a, vec3 b, float u) { return 1.0; }
#endif
