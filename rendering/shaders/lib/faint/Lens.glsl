// A lens over the context's surface says how much stays (the interface is described in None.glsl).
#include "lib/None.glsl"
#include "lib/faint/Layer.glsl"

const bool HAS_LENS = true;
uniform sampler2D lensSurface;  // LensPass; a sampler as protectedLayer is
uniform vec3 lens;              // 1/mm of its radius; bends; rim
uniform int lensFade;           // LensFade

// How far out a place is, in radii, along the context's surface; beyond anything where that has no place before the focus.
float placeInLens(ivec2 pixel) {
  float distance = texelFetch(lensSurface, pixel, 0).w;
  return isNone(distance) ? FAR : distance * lens.x;
}

float faintShare(ivec2 pixel, ivec2 last, vec2 hit) {
  vec3 normal = texelFetch(lensSurface, pixel, 0).xyz, bend = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 step = (i & 2) == 0 ? ivec2(1, 0) : ivec2(0, 1);
    ivec2 beside = clamp((i & 1) == 0 ? pixel + step : pixel - step, ivec2(0), last);
    bend += abs(texelFetch(lensSurface, beside, 0).xyz - normal);
  }
  float place = placeInLens(pixel), kept = clamp(place, 0.0, 1.0);
  if (lensFade != 0 && place < 1.0)
    kept = lensFade == 1 ? 0.0 : isNone(hit.y) ? 1.0 : clamp((hit.y - hit.x) * lens.x, 0.0, 1.0);
  return clamp(max(length(bend) * lens.y, kept), 0.0, 1.0);
}

vec4 withFaint(vec4 result, ivec2 pixel, float share) {
  vec4 faint = faintAt(pixel, share);
  return faint + (1.0 - faint.a) * result;
}

float lensLine(ivec2 pixel) { return 0.5 * (1.0 - clamp(abs(placeInLens(pixel) - 1.0) * lens.z, 0.0, 1.0)); }
