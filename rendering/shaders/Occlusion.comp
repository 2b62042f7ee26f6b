// The medium that casts shadows, second step: what is left of ambient and of direct light at the centre of each cell.
// rendering/scene/Occlusion.h defines it. An invocation a cell: x, and y and z one below the other.
#include <schedule>
#include "lib/None.glsl"
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 5) readonly buffer OccludingMedium { float medium[]; };            // 1/mm
layout(std430, binding = 6) writeonly buffer OcclusionNodeValues { uint nodeValues[]; };    // lib/light/Occlusion.glsl
layout(std430, binding = 7) readonly buffer OcclusionDirections { vec4 directions[]; };     // cells per mm

const float OPAQUE = 14.0;  // optical depth: less than 1e-6 passes

uint indexOf(ivec3 cell) {
  return uint(cell.x) + uint(occlusion.dims.x) * (uint(cell.y) + uint(occlusion.dims.y) * uint(cell.z));
}

// Integral of a ramp from 0 at x to 1 at y, from 0 to s.
float ramp(float s, vec2 ends) {
  float size = ends.y - ends.x, u = clamp((s - ends.x) / size, 0.0, 1.0);
  return 0.5 * size * u * u + max(s - ends.y, 0.0);
}

// From the centre of a cell. `fade`: mm; behind its second value nothing counts.
float transmittance(ivec3 cell, vec3 direction, vec2 fade) {
  vec3 along = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12))), inverse = 1.0 / along;
  // The weight is 0 before the ramp begins.
  float s = occlusion.ramp.x;
  vec3 place = vec3(cell) + 0.5 + s * along;
  ivec3 at = ivec3(floor(place)), way = ivec3(sign(along));
  vec3 next = s + (vec3(at) + max(vec3(way), 0.0) - place) * inverse, perCell = abs(inverse);
  float depth = 0.0, before = 0.0;
  bool goes = all(greaterThanEqual(at, ivec3(0))) && all(lessThan(at, occlusion.dims));
  do {
    if (goes) {
      s = min(min(next.x, next.y), min(next.z, fade.y));
      float weight = ramp(s, occlusion.ramp) - ramp(s, fade);
      depth += medium[indexOf(at)] * (weight - before);
      before = weight;
      bvec3 leaves = bvec3(next.x <= s, next.y <= s && next.x > s, next.z <= s && next.x > s && next.y > s);
      at += mix(ivec3(0), way, leaves);
      next += mix(vec3(0.0), perCell, leaves);
      goes = s < fade.y && depth < OPAQUE && all(greaterThanEqual(at, ivec3(0))) && all(lessThan(at, occlusion.dims));
    }
  } while (goes);
  return exp(-depth);
}

// Whether something may show within one cell of a centre.
bool isNeeded(ivec3 cell) {
  float sum = 0.0;
  for (int i = 0; i < 27; ++i)
    sum += medium[indexOf(clamp(cell + ivec3(i % 3, i / 3 % 3, i / 9) - 1, ivec3(0), occlusion.dims - 1))];
  return sum > 0.0;
}

void main() {
  ivec2 pixel = regionPixel();
  if (pixel.x >= occlusion.dims.x || pixel.y >= occlusion.dims.y * occlusion.dims.z) return;
  ivec3 cell = ivec3(pixel.x, pixel.y % occlusion.dims.y, pixel.y / occlusion.dims.y);
  vec2 open = vec2(1.0);
  if (isNeeded(cell)) {
    vec2 sum = vec2(0.0);
    for (int i = 0; i < occlusion.around; ++i) sum.x += transmittance(cell, directions[i].xyz, occlusion.fade);
    for (int i = 0; i < occlusion.towardsLight; ++i)
      sum.y += transmittance(cell, directions[occlusion.around + i].xyz, vec2(FAR, 2.0 * FAR));
    vec2 means = sum / max(vec2(occlusion.around, occlusion.towardsLight), vec2(1.0));
    open = 1.0 - occlusion.strength * (1.0 - vec2(min(2.0 * means.x, 1.0), means.y));
  }
  nodeValues[indexOf(cell)] = packUnorm2x16(open);
}
