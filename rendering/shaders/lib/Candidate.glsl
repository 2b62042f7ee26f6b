// Rays of candidate cameras: parallel projection over the model's bounding sphere, one set of axes a view.
#include <schedule>
#include <clip>
#include "lib/Ray.glsl"
#include "lib/Uniforms.glsl"

struct CandidateView {  // right, up and forward in cells per mm
  vec4 right;           // w: 1 where the view from the opposite side is wanted too
  vec4 up;
  vec4 forward;
};
layout(std430, binding = 2) readonly buffer Views { CandidateView views[]; };

// s = 0 at the plane through the centre; position in -1…1 across the image.
Ray candidateRay(uint view, vec2 position) {
  Ray ray;
  ray.direction = views[view].forward.xyz;
  vec3 offset = position.x * views[view].right.xyz + position.y * views[view].up.xyz;
  ray.base = candidates.sphereCentre + candidates.sphereRadius * offset;
  ray.world = ray.worldBase = vec3(0.0);
  clipTo(ray, candidates.focusLower, candidates.focusUpper, -candidates.sphereRadius);
  clipToHalfSpaces(ray);
  return ray;
}

Ray reversed(Ray ray) {
  ray.direction = -ray.direction;
  clipTo(ray, candidates.focusLower, candidates.focusUpper, -candidates.sphereRadius);
  clipToHalfSpaces(ray);
  return ray;
}
