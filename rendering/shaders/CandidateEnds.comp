// Which rays of candidate images that meet the focus come in through an end of the scan: the first point of context or
// focus on such a ray is where it enters the volume's box.
#include "lib/Candidate.glsl"
#include "lib/CandidateTiles.glsl"
#include "lib/FirstHit.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 4) readonly buffer Hits { vec2 hits[]; };  // a pixel's depth from the front, from behind
layout(std430, binding = 6) writeonly buffer Ends { uint ends[]; };  // bit 0: from the front; bit 1: from behind

// Share of the sphere's radius within which a depth is the one of the entry point: the depth is a float32 of order one.
const float SAME_DEPTH = 1e-5;

// `depth`: of the first point of the focus, as in the hits.
bool entersTissue(Ray ray, float depth) {
  clipTo(ray, vec3(0.5), vec3(volume.dims) + 0.5, -candidates.sphereRadius);
  clipToHalfSpaces(ray);
  if (CLIPS && ray.cap >= 0) return false;  // a face that the user cut is no end of the scan
  if (2.0 * depth - 1.0 <= ray.sIn / candidates.sphereRadius + SAME_DEPTH) return true;
  float value = storedExact(cellPosition(ray, ray.sIn));
  for (int i = 0; i < gapCount; ++i)
    if (value > gaps[i].x && value < gaps[i].y) return false;
  return true;
}

void main() {
  uint tile = tileOfGroup();
  if (tile >= uint(tileCount)) return;
  uint view = tiles[tile].view;
  uint pixel = pixelOf(tile, ivec2(gl_LocalInvocationID.xy));
  vec2 depth = hits[pixel];
  uint found = 0u;
  if (!isNone(depth.x)) {
    Ray ray = candidateRay(view, imagePosition(vec2(placeOf(pixel))));
    if (entersTissue(ray, depth.x)) found = 1u;
    if (views[view].right.w != 0.0 && entersTissue(reversed(ray), depth.y)) found |= 2u;
  }
  ends[pixel] = found;
}
