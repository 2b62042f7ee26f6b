// The context fades outside of a focal region. A part of FocalRegion.glsl and FocalDistance.glsl.
#include "lib/fading/Settings.glsl"

// Uniforms of their own, as those of Settings.glsl.
uniform float focalSize;        // mm: radius, half the side, or distance from the focus
uniform float focalPerFallOff;  // 1/mm

const bool FOLLOWS_LIGHT = false;

float sharpnessOfFade() { return 0.0; }
bool mayFade(vec2 ends) { return true; }

// At a point with a gradient of this length (steepest: 1), `outside` mm outside of the region.
float fadeAround(float slope, float outside) {
  return slope > 0.0 ? log2(min(slope, 1.0)) - focalPerFallOff * max(outside, 0.0) : -1e30;
}
