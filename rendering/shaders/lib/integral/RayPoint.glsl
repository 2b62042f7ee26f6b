// Points along a ray, and what the volume holds there, for the integral from face to face.
#include <normals>
#include <occlusion>
#include <volume>
#include "lib/Ray.glsl"
#include "lib/TransferTables.glsl"

// Where a ray is, and what the volume holds there.
struct RayPoint {
  float s;       // mm along the ray
  float stored;
  float entry;   // of the value in the tables
  vec3 gated;    // normal
  vec2 open;     // shares of ambient and of direct light that arrive there; with OCCLUDES
};

// At a face by which the ray enters `cell`. From cell to cell the sum of the indices changes by one, whatever is skipped,
// so the bounds of neighbouring faces lie at least LEAST_SPAN apart.
void classify(inout RayPoint point, ivec3 cell) {
  float phase = LEAST_SPAN * float((cell.x + cell.y + cell.z) & 1);
  point.entry = entryNear(entryOf(point.stored), phase);
}

vec3 withinCell(Ray ray, ivec3 cell, float s) { return clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0); }

// The gated normal inside a cell, trilinear.
vec3 gatedInside(Ray ray, ivec3 cell, float s) {
  vec3 w = withinCell(ray, cell, s), gated = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    vec3 weights = mix(1.0 - w, w, bvec3(cornerOf(i)));
    gated += weights.x * weights.y * weights.z * gatedAt(cell - 1 + cornerOf(i));
  }
  return gated;
}

// Trilinear between the cell's eight texels, also of a spline, as points on faces are bilinear between four.
RayPoint pointInside(Ray ray, ivec3 cell, float s) {
  RayPoint point;
  point.s = s;
  point.stored = storedBetween(cellPosition(ray, s));
  point.gated = gatedInside(ray, cell, s);
  if (OCCLUDES) point.open = openAt(cellPosition(ray, s));
  return point;
}

// Part of the way from one point to another.
RayPoint between(RayPoint front, RayPoint back, float u) {
  RayPoint point;
  point.s = mix(front.s, back.s, u);
  point.stored = mix(front.stored, back.stored, u);
  point.entry = entryOf(point.stored);
  point.gated = mix(front.gated, back.gated, u);
  if (OCCLUDES) point.open = mix(front.open, back.open, u);
  return point;
}
