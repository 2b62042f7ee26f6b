// Where the outline of the focus crosses each edge of a list, by bisection with more rays.
#include "lib/Candidate.glsl"
#include "lib/CandidateTiles.glsl"
#include "lib/FirstHit.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 6) readonly buffer Crossed {
  uint crossedCount;
  uint crossed[];
};
layout(std430, binding = 7) writeonly buffer Crossings { float crossings[]; };  // 0…1 along each edge
uniform int halvings;  // of an edge: how closely a crossing is found

void main() {
  uint at = 64u * tileOfGroup() + gl_LocalInvocationIndex;
  if (at >= crossedCount) return;
  bool seen = (crossed[at] & 1u) != 0u;
  uint edge = crossed[at] >> 1, pixel = edge >> 1;
  vec2 from = vec2(placeOf(pixel)), along = (edge & 1u) == 0u ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
  float low = 0.0, high = 1.0;
  for (int i = 0; i < halvings; ++i) {
    float middle = 0.5 * (low + high);
    if (meetsFocus(candidateRay(tiles[pixel >> 6].view, imagePosition(from + middle * along))) == seen) low = middle;
    else high = middle;
  }
  crossings[edge] = 0.5 * (low + high);
}
