// Which points of the focus's surface each candidate camera sees: a ray from the point towards the camera, which nothing
// of the focus may stop.
#include "lib/Ray.glsl"
#include "lib/Volume.glsl"
#include "lib/Crossing.glsl"
#include "lib/FocusIndex.glsl"
#include "lib/FirstHit.glsl"
#include "lib/Candidate.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
struct SurfacePoint {
  vec4 position;  // cell frame, lifted off the surface
  vec4 facing;    // world normal in cells: dot(facing, forward) ≤ 0 where the camera looks onto the surface
};
layout(std430, binding = 3) readonly buffer Points { SurfacePoint points[]; };
uniform int pointCount;
uniform float clearance;  // mm along the ray that the surface may not hide itself in
layout(r8ui, binding = 0) uniform writeonly uimage2D seen;  // x: point, y: candidate

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= pointCount || at.y >= imageSize(seen).y) return;
  uint visible = 0u;
  vec3 towards = -candidates[at.y].forward.xyz;
  if (dot(points[at.x].facing.xyz, towards) >= 0.0) {
    Ray ray;
    ray.direction = towards;
    ray.base = points[at.x].position.xyz + clearance * towards;
    ray.world = ray.worldBase = vec3(0.0);
    clipToBox(ray, 0.0);
    visible = ray.sIn > ray.sOut || isNone(firstFocusHit(ray)) ? 1u : 0u;
  }
  imageStore(seen, at, uvec4(visible));
}
