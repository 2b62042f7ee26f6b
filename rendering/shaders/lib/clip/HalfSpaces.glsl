// What clips the volume (rendering/settings/Clipping.h): half-spaces, of which every ray keeps one stretch. A part of Faces.glsl
// and GreyFaces.glsl.
#include <schedule>
#include "lib/Ray.glsl"
#include "lib/Uniforms.glsl"

const bool CLIPS = true;
const float ALONG_PLANE = 1e-7;    // cosine below which a ray runs along a plane

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

vec3 capNormal(Ray ray) {
  vec3 normal = vec3(0.0);
  for (int i = 0; i < HALF_SPACES; ++i) normal = i == ray.cap ? clipping.normals[i].xyz : normal;
  return normal;
}

float keptShare(vec3 position, float width) {
  float share = 1.0;
  for (int i = 0; i < HALF_SPACES; ++i) {
    float before = dot(clipping.planes[i].xyz, position) + clipping.planes[i].w;
    // Planes that are not in use have no normal.
    bool used = dot(clipping.normals[i].xyz, clipping.normals[i].xyz) > 0.5;
    share *= used ? clamp(before / width + 0.5, 0.0, 1.0) : 1.0;
  }
  return share;
}
