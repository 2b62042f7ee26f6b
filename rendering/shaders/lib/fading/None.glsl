// Nothing fades.
//
// ContextPreserving.glsl, FocalRegion.glsl, FocalDistance.glsl and Ghost.glsl have the same interface; `#include <fading>`
// names the one that the picture needs. They say what the context's extinction is multiplied by (MethodStages::Fading in
// rendering/vocabulary/MethodStages.h): a factor, of which they give the binary logarithm.
//   FADES             whether any of the context may fade
//   FOLLOWS_LIGHT     whether what lies before a point on the ray decides; else its place does
//   BORDERS_IN_TURN   whether wholeBehind() tells the next border alone
//   sharpnessOfFade   with FOLLOWS_LIGHT, the power of the transmittance that counts; else 0
//   slopeFromIndex    gradients (world, 1 for the steepest) from those of coded values by the voxel's index
//   gatedSlope        the gated normal of such a gradient
//   outsideAlong      mm outside of a region along a path through a cell, negative inside; Bernstein coefficients
//   mayFade           whether something may fade on a stretch of a ray. `ends`: of the stretch, mm
//   fadeOf            the factor at a point behind nothing
//   wholeBehind       where a stretch of a ray, 0 to 1, enters and leaves what shows as it is, behind x: a focal region, or
//                     what lies between two ghosts. Where nothing of it comes, the first is greater than 1. `ends`: of the
//                     stretch, mm; `within`: its ends on the path whose slopes these are, 0 to 1
#include "lib/Ray.glsl"
#include "lib/fading/Slopes.glsl"

const bool FADES = false, FOLLOWS_LIGHT = false, BORDERS_IN_TURN = false;

float sharpnessOfFade() { return 0.0; }
mat3 slopeFromIndex() { return mat3(0.0); }
vec3 gatedSlope(vec3 slope) { return vec3(0.0); }
vec4 outsideAlong(ivec3 cell, vec3 a, vec3 b) { return vec4(0.0); }
bool mayFade(vec2 ends) { return false; }
float fadeOf(Slopes slopes, float along, Ray ray, float s, vec2 light) { return 0.0; }
vec2 wholeBehind(Slopes slopes, vec2 within, Ray ray, vec2 ends, float x) { return vec2(3e38, -3e38); }
