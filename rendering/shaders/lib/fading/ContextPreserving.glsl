// The context fades where it is flat, brightly lit and near, the less the more opaque the ray is already (the interface is
// described in None.glsl).
#include <light>
#include "lib/Crossing.glsl"
#include "lib/fading/Settings.glsl"

const bool FOLLOWS_LIGHT = true, BORDERS_IN_TURN = false;

float sharpnessOfFade() { return fading.sharpness; }
vec4 outsideAlong(ivec3 cell, vec3 a, vec3 b) { return vec4(0.0); }
bool mayFade(vec2 ends) { return true; }

// At a point with a gradient of this length (steepest: 1), light and place. Behind the transmittance T the logarithm is
// T^sharpness of that.
float fadeAt(float slope, float intensity, float s) {
  float near = clamp(s * fading.nearness.x + fading.nearness.y, 0.0, 1.0);
  float exponent = pow(fading.reach * intensity * near, fading.sharpness);
  float whole = slope > 0.0 ? exponent * log2(min(slope, 1.0)) : -1e30;
  return exponent > 0.0 ? whole : 0.0;
}

float fadeOf(Slopes slopes, float along, Ray ray, float s, vec2 light) {
  vec3 slope = bernstein(slopes.along, along);
  return fadeAt(length(slope), intensityOf(light), s);
}

vec2 wholeBehind(Slopes slopes, vec2 within, Ray ray, vec2 ends, float x) { return vec2(3e38, -3e38); }
