// Which points of the focus's surface each candidate camera sees: a ray from the point towards the camera, which nothing
// of the focus may stop.
#include "lib/Candidate.glsl"
#include "lib/FirstHit.glsl"

layout(local_size_x = 64) in;
struct SurfacePoint {
  vec4 position;  // cell frame; w: mm along the normal within which the surface may lie elsewhere
  vec4 facing;    // world normal in cells: dot(facing, forward) < 0 where the camera looks onto the surface
};
layout(std430, binding = 3) readonly buffer Points { SurfacePoint points[]; };
uniform int pointCount;
layout(r8ui) uniform writeonly uimage2D seen;  // x: point, y: candidate

// The most that a ray starts off the surface, in units of the surface's uncertainty: seen nearly edge-on, no distance would
// clear it.
const float MOST_CLEARANCE = 8.0;
const float EDGE_ON = 1e-5;  // cosine: above what rounding makes of a zero

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= pointCount) return;
  uint visible = 0u;
  vec3 towards = -views[at.y].forward.xyz;
  float slope = dot(points[at.x].facing.xyz, towards);
  // Normals of a voxelised surface are often edge-on to the lattice's axes exactly: every other such point faces the
  // camera.
  if (abs(slope) < EDGE_ON ? (at.x & 1) == 0 : slope > 0.0) {
    // The steps of a voxelised surface must not hide it from itself: the ray starts where it has left them behind.
    float clearance = points[at.x].position.w * min(1.0 / max(slope, EDGE_ON), MOST_CLEARANCE);
    Ray ray;
    ray.direction = towards;
    ray.base = points[at.x].position.xyz + clearance * towards;
    ray.world = ray.worldBase = vec3(0.0);
    clipTo(ray, candidates.focusLower, candidates.focusUpper, 0.0);
    clipToHalfSpaces(ray);
    visible = meetsFocus(ray) ? 0u : 1u;
  }
  imageStore(seen, at, uvec4(visible));
}
