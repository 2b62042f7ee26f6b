// What clips the volume (rendering/scene/Clipping.h): half-spaces, of which every ray keeps one stretch.
//
// CLIPPED is 0 where nothing clips: nothing of this file is compiled then. 2: capped faces show values in grey.
#include <schedule>
#include "lib/Ray.glsl"
#include "lib/Uniforms.glsl"

#if CLIPPED
const float ALONG_PLANE = 1e-7;    // cosine below which a ray runs along a plane

// Shortens a ray to what is kept of it.
void clipToHalfSpaces(inout Ray ray) {
  ray.cap = -1;
  for (int i = 0; i < HALF_SPACES; ++i) {
    vec4 plane = clipping.planes[i];
    float slope = dot(plane.xyz, ray.direction), before = dot(plane.xyz, ray.base) + plane.w;
    bool along = abs(slope) < ALONG_PLANE;
    float s = -before / (along ? 1.0 : slope);
    float enter = along ? (before < 0.0 ? FAR : -FAR) : slope > 0.0 ? s : -FAR;
    float leave = along || slope > 0.0 ? FAR : s;
    ray.cap = enter > ray.sIn ? i : ray.cap;
    ray.sIn = max(ray.sIn, enter);
    ray.sOut = min(ray.sOut, leave);
  }
}

// Normal of the capped face that a ray enters by, whose cap is not -1.
vec3 capNormal(Ray ray) {
  vec3 normal = vec3(0.0);
  for (int i = 0; i < HALF_SPACES; ++i) normal = i == ray.cap ? clipping.normals[i].xyz : normal;
  return normal;
}
#else
void clipToHalfSpaces(inout Ray ray) {}
#endif
