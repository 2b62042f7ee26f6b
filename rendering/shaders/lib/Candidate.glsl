// Rays of candidate cameras: parallel projection over the model's bounding sphere, one set of axes a candidate.

struct CandidateAxes {  // cells per mm along the camera's right, up and forward
  vec4 right, up, forward;
};
layout(std430, binding = 2) readonly buffer Candidates { CandidateAxes candidates[]; };
uniform vec3 sphereCentre;   // cell frame
uniform float sphereRadius;  // mm

// s = 0 at the plane through the centre; position in -1…1 across the image.
Ray candidateRay(uint candidate, vec2 position) {
  CandidateAxes axes = candidates[candidate];
  Ray ray;
  ray.direction = axes.forward.xyz;
  ray.base = sphereCentre + sphereRadius * (position.x * axes.right.xyz + position.y * axes.up.xyz);
  ray.world = ray.worldBase = vec3(0.0);
  clipToBox(ray, -sphereRadius);
  return ray;
}
