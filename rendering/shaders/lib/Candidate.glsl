// Rays of candidate cameras: parallel projection over the model's bounding sphere, one set of axes a view.

struct CandidateView {  // right, up and forward in cells per mm
  vec4 right;           // w: 1 where the view from the opposite side is wanted too
  vec4 up;
  vec4 forward;
};
layout(std430, binding = 2) readonly buffer Views { CandidateView views[]; };
uniform vec3 sphereCentre;   // cell frame
uniform float sphereRadius;  // mm
uniform vec3 focusLower, focusUpper;  // cell frame: nothing of the focus lies outside

// s = 0 at the plane through the centre; position in -1…1 across the image.
Ray candidateRay(uint view, vec2 position) {
  Ray ray;
  ray.direction = views[view].forward.xyz;
  ray.base = sphereCentre + sphereRadius * (position.x * views[view].right.xyz + position.y * views[view].up.xyz);
  ray.world = ray.worldBase = vec3(0.0);
  clipTo(ray, focusLower, focusUpper, -sphereRadius);
  return ray;
}

Ray reversed(Ray ray) {
  ray.direction = -ray.direction;
  clipTo(ray, focusLower, focusUpper, -sphereRadius);
  return ray;
}
