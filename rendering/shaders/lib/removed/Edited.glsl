// Brush strokes have edited the opening that another camera cuts (the interface is described in Unedited.glsl).
#include "lib/Bilinear.glsl"
#include "lib/Uniforms.glsl"

layout(rg32f) uniform writeonly image2D editMap;
uniform sampler2D openingEdits;  // EditMap.comp's, of that camera's picture

const bool EDITED = true;

float editFactor(ivec2 corner, vec2 at) {
  ivec2 last = opening.pictureSize - 1;
  vec4 factors;
  for (int i = 0; i < 4; ++i)
    factors[i] = texelFetch(openingEdits, clamp(corner + ivec2(i & 1, i >> 1), ivec2(0), last), 0).g;
  return bilinear(factors, at);
}

void storeEdit(ivec2 pixel, float factor) { imageStore(editMap, pixel, vec4(0.0, factor, 0.0, 0.0)); }
