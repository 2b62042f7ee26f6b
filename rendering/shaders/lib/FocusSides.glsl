// Where the focus begins and ends along a path within a cell.
#include <focus>
#include "lib/Crossing.glsl"

// Below, in or above the focus's range: -1, 0, 1.
float sideOf(float value) {
  vec2 range = focusRange();
  return value < range.x ? -1.0 : value > range.y ? 1.0 : 0.0;
}

// The first u' > u, at most 1, where the focus begins or ends.
float nextChange(vec4 along, float u) {
  vec2 turns = turningPoints(along);
  float from = u, to = 1.0, side = sideOf(bernstein(along, u));
  bool changes = false;
  for (int i = 0; i < 3; ++i) {
    float end = i < 2 ? turns[i] : 1.0;
    if (changes || end <= from) continue;
    changes = sideOf(bernstein(along, end)) != side;
    if (changes) to = end;
    else from = end;
  }
  if (!changes) from = to;
  // Bisection in a monotone piece, down to rounding.
  for (int i = 0; i < 22 && from < to; ++i) {
    float middle = 0.5 * (from + to);
    if (sideOf(bernstein(along, middle)) != side) to = middle;
    else from = middle;
  }
  return to;
}
