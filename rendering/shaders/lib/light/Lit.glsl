// The lighting model (rendering/scene/Lighting.h; the interface is described in Unlit.glsl).
#include "lib/light/BlinnPhong.glsl"

const bool LIT = true;

// The light fades in with the gated normal's length.
vec2 lightOfGated(vec3 normal, vec3 rayDirection) {
  vec2 flatLight = vec2(lighting.ambient + lighting.meanIncidence * lighting.diffuse, 0.0);
  float size = dot(normal, normal);
  if (!(size > 1e-6)) return flatLight;
  float inverse = inversesqrt(size);
  float certainty = smoothstep(0.0, lighting.certainLength, size * inverse);
  return mix(flatLight, lightOf(normal * inverse, rayDirection), certainty);
}

float intensityOf(vec2 light) { return clamp(light.x - lighting.ambient + light.y, 0.0, 1.0); }
