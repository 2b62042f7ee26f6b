// A search looks into a cell of a spline (the interface is described in Cell.glsl).
#include <focus>
#include <translucent>
#include <volume>
#include "lib/Crossing.glsl"
#include "lib/Search.glsl"
#include "lib/VoxelCell.glsl"

const int THIRDS = 3;

// Seven values' weights in a value between them.
float weighted(SplineAlong along, vec4 first, vec3 last) {
  return dot(first, vec4(along.at[0], along.at[1], along.at[2], along.at[3])) +
         dot(last, vec3(along.at[4], along.at[5], along.at[6]));
}

// A third of a path, nearer to the spline than a half of it is: through points of the polynomial through all seven values.
vec4 thirdOf(SplineAlong along, int third) {
  // Lagrange's weights at 1/9, 2/9 and 4/9; the other half's are the same ones backwards.
  const vec4 first1 = vec4(728, 8736, -5460, 4160) / 6561.0, first2 = vec4(-154, 3696, 4620, -2464) / 6561.0,
             first4 = vec4(35, -336, 2100, 5600) / 6561.0;
  const vec3 last1 = vec3(-2184, 672, -91) / 6561.0, last2 = vec3(1155, -336, 44) / 6561.0,
             last4 = vec3(-1050, 240, -28) / 6561.0;
  SplineAlong back;
  for (int i = 0; i < POINTS; ++i) back.at[i] = along.at[POINTS - 1 - i];
  if (third == 0)
    return bernsteinThrough(along.at[0], weighted(along, first1, last1), weighted(along, first2, last2), along.at[2]);
  if (third == 1)
    return bernsteinThrough(along.at[2], weighted(along, first4, last4), weighted(back, first4, last4), along.at[4]);
  return bernsteinThrough(along.at[4], weighted(back, first2, last2), weighted(back, first1, last1), along.at[6]);
}

// Into the rest of a cell of the voxels, for the first third in which the field leaves the gap.
void look(inout Search search, const bool ofFocus, Ray ray, float sEnd) {
  ivec3 cell = middleOf(search.cell);
  float sFrom = search.s;
  moveOn(search, ray, sEnd, voxelBlockAt(search.cell, search.upwards));
  float sTo = min(search.s, sEnd);
  vec3 a = withinMiddle(cellPosition(ray, sFrom) - vec3(cell)), b = withinMiddle(cellPosition(ray, sTo) - vec3(cell));
  SplineAlong values = splineAlong(cell, a, b);
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  vec4 thirds[THIRDS];
  for (int i = 0; i < THIRDS; ++i) {
    float from = float(i) / float(THIRDS), to = float(i + 1) / float(THIRDS);
    thirds[i] = thirdOf(values, i);
    if (ofFocus) thirds[i] = focusAlong(held, mix(a, b, from), mix(a, b, to), thirds[i]);
  }
  if (ofFocus) search.gap = gapAround(thirds[0].x);
  search.after = search.stage;
  for (int i = THIRDS - 1; HAS_FAINT && !ofFocus && i >= 0; --i) {
    float from = float(i) / float(THIRDS), to = float(i + 1) / float(THIRDS);
    float u = firstContextExit(cell, mix(a, b, from), mix(a, b, to), thirds[i]);
    if (u <= 1.0) search.hit = mix(sFrom, sTo, mix(from, to, u));
    if (u <= 1.0) search.stage = ENDED;
  }
  for (int i = THIRDS - 1; (!HAS_FAINT || ofFocus) && i >= 0; --i) {
    vec2 piece;
    if (!leaves(thirds[i], search.gap.x, search.gap.y, piece)) continue;
    search.along = thirds[i];
    search.sFrom = mix(sFrom, sTo, float(i) / float(THIRDS));
    search.sTo = mix(sFrom, sTo, float(i + 1) / float(THIRDS));
    search.stage = SOLVE;
  }
}
