// Rays through the volume.
//
// Cell frame: index + 1. Cell c spans [c, c+1] between voxel centres; the volume's box is [½, dims+½], so coordinates
// inside it are positive and truncation is floor. Positions along a ray are s in mm from its base.
#include "lib/None.glsl"

struct Ray {
  vec3 base;        // cell frame, at s = 0
  vec3 direction;   // cells per mm
  vec3 inverse;     // mm per cell; 0 on axes the ray is parallel to
  vec3 world;       // unit direction in world space
  vec3 worldBase;   // world position at s = 0 relative to the middle of the anchor plane, mm
  float sIn, sOut;  // inside the box and in front of the eye; sIn > sOut: the ray misses the box
  int cap;          // where `<clip>` clips, the half-space by which the ray enters; -1: by the box, or it starts inside
};

// Fills in the inverse and the part of the ray inside a box of the cell frame, from s = sFirst on.
void clipTo(inout Ray ray, vec3 lower, vec3 upper, float sFirst) {
  bvec3 parallel = lessThan(abs(ray.direction), vec3(1e-7 * length(ray.direction)));
  ray.inverse = mix(1.0 / ray.direction, vec3(0.0), parallel);
  vec3 a = (lower - ray.base) * ray.inverse, b = (upper - ray.base) * ray.inverse;
  bvec3 outside = bvec3(uvec3(lessThan(ray.base, lower)) | uvec3(greaterThan(ray.base, upper)));
  vec3 near = mix(min(a, b), mix(vec3(-FAR), vec3(FAR), outside), parallel);
  vec3 far = mix(max(a, b), vec3(FAR), parallel);
  ray.sIn = max(max(near.x, near.y), max(near.z, sFirst));
  ray.sOut = min(far.x, min(far.y, far.z));
}

vec3 cellPosition(Ray ray, float s) { return ray.base + s * ray.direction; }
vec3 worldPosition(Ray ray, float s) { return ray.worldBase + s * ray.world; }
