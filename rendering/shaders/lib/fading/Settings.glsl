// What all fading contexts read. A part of the alternatives of `<fading>`.
#include "lib/Ray.glsl"
#include "lib/fading/Slopes.glsl"

struct FadingSettings {
  mat3 slopeFromIndex;
  vec2 nearness;        // 1 - d = s · x + y
  float reach;
  float sharpness;
};
// Uniforms of their own and no block: while lavapipe of Mesa 22.3 prepares a program whose branches depend on an eighth
// uniform buffer, it writes beyond its own memory.
uniform vec3 slopeFromIndexX, slopeFromIndexY, slopeFromIndexZ;  // columns
uniform vec2 fadingNearness;
uniform float fadingReach, fadingSharpness;
FadingSettings fading = FadingSettings(mat3(slopeFromIndexX, slopeFromIndexY, slopeFromIndexZ), fadingNearness,
                                       fadingReach, fadingSharpness);

const bool FADES = true;

mat3 slopeFromIndex() { return fading.slopeFromIndex; }

// As lib/normals/Gradient.glsl has gated normals, but without the texture's rounding: where a context fades, an error of its
// light early on a ray may grow behind.
uniform vec2 gradientGate;  // of gradients of which the steepest is 1
vec3 gatedSlope(vec3 slope) {
  float size = length(slope);
  return size > gradientGate.x ? slope * (smoothstep(gradientGate.x, gradientGate.y, size) / size) : vec3(0.0);
}
