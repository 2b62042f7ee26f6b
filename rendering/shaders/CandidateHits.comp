// First focus hits of many candidate images: a work group is one 8×8 tile of one view. A ray met from both ends serves
// the opposite view too: the two have the same outline.
#include "lib/Candidate.glsl"
#include "lib/CandidateTiles.glsl"
#include "lib/FirstHit.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 4) writeonly buffer Hits { vec2 hits[]; };  // a pixel's depth from the front, from behind

void main() {
  uint tile = tileOfGroup();
  if (tile >= uint(tileCount)) return;
  uint view = tiles[tile].view;
  uint pixel = pixelOf(tile, ivec2(gl_LocalInvocationID.xy));
  vec2 depth = vec2(NONE);
  Ray ray = candidateRay(view, imagePosition(vec2(placeOf(pixel))));
  float front = firstFocusHit(ray);
  if (!isNone(front)) {
    depth = vec2(0.5 + 0.5 * front / candidates.sphereRadius, 0.0);
    if (views[view].right.w != 0.0) {
      float back = firstFocusHit(reversed(ray));
      // A ray that grazes may be met from one end alone; seen from the other, its point is where this end met it.
      depth.y = isNone(back) ? 1.0 - depth.x : 0.5 + 0.5 * back / candidates.sphereRadius;
    }
  }
  hits[pixel] = depth;
}
