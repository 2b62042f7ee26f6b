// No lighting: colours are shown as they are.
//
// Lit.glsl has the same interface; `#include <light>` names the one that the picture needs. A light is two numbers: shaded
// colour = colour · x + y.
//   LIT           whether there is any lighting
//   lightOf       the light on a surface with a normal
//   lightOfGated  the light at a point of the context, from the gated normal there
//   intensityOf   how strongly a light gives back what is not ambient, 0 to 1

const bool LIT = false;
const vec2 UNLIT = vec2(1.0, 0.0);

vec2 lightOf(vec3 normal, vec3 rayDirection) { return UNLIT; }
vec2 lightOfGated(vec3 gated, vec3 rayDirection) { return UNLIT; }
float intensityOf(vec2 light) { return 1.0; }
