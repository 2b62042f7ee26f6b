// A search for the first hit of the focus, or of the context, along a ray: its state, and how it moves on (lib/FirstHit.glsl).
#include <focus>
#include <translucent>
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/Traversal.glsl"

// Where there is none of the focus, and where the context is transparent, as emptyAround() reads them.
UNSIGNED_TEXELS_3D(r16ui, focusSkip);
UNSIGNED_TEXELS_3D(r16ui, contextSkip);

// Open intervals of stored values in which the context is transparent, for each of its translucent labels and, first, all else (`<translucent>`).
uniform int gapCount;
layout(std430, binding = 1) readonly buffer Gaps { vec2 gaps[]; };

const int LEAP = 0, LOOK = 1, SOLVE = 2, ENDED = 3;

struct Search {
  ivec3 upwards;
  ivec3 cell;   // that the ray is in from s on
  float s;
  int stage;
  int after;    // the stage after SOLVE: LEAP or ENDED
  float sFrom;  // where the ray came into the cell looked into, or that third of a path which is solved
  float sTo;    // the end of what `along` covers
  vec4 along;   // the field from sFrom to sTo, Bernstein coefficients
  vec2 gap;     // open interval that the field has to leave
  float hit;
};

// The gap of a label that holds a value; an empty one where none does.
vec2 gapAround(int label, float value) {
  vec2 found = vec2(FAR, -FAR);
  for (int i = 0; i < gapCount; ++i) {
    vec2 gap = gaps[label * gapCount + i];
    found = mix(found, gap, bvec2(value > gap.x && value < gap.y));
  }
  return found;
}

// Moves on to what lies behind a block; the search ends where the ray or the volume does.
void moveOn(inout Search search, Ray ray, float sEnd, Block block) {
  Face face = faceBehind(block, ray, search.upwards, search.s);
  search.s = face.s;
  search.cell = cellBehind(face, search.upwards);
  search.stage = face.s < sEnd && isInVolume(search.cell) ? LEAP : ENDED;
}

// `ofFocus` chooses the field.
void leap(inout Search search, const bool ofFocus, Ray ray, float sEnd) {
  ivec3 brick = search.cell >> BRICK_SHIFT;
  int empty = emptyAround(ofFocus ? texelOf(focusSkip, brick).r : texelOf(contextSkip, brick).r, search.cell);
  bool found = empty == 0;
  if (ofFocus) found = found && mayHoldFocus(focusCellAt(focusSlot(search.cell), search.cell));
  if (found)
    search.stage = LOOK;
  else
    moveOn(search, ray, sEnd, blockAt(search.cell, search.upwards, empty));
}

// The gap that the focus's field has to leave. A ray that comes into a cell inside the focus has met it there: no value lies
// in the empty gap.
vec2 gapAround(float first) {
  vec2 range = focusRange();
  return first < range.x ? vec2(-FAR, range.x) : first > range.y ? vec2(range.y, FAR) : vec2(FAR, -FAR);
}

// The u where, along a path within a cell, the context begins by the labels there; 2 where it does not. `along`: the field.
float firstContextExit(ivec3 cell, vec3 a, vec3 b, vec4 along) {
  uint labels = labelsIn(cell);
  float from = 0.0, to = 0.0, found = 2.0;
  do {
    to = labelsDiffer(labels) ? nextLabel(a, b, from) : 1.0;
    vec2 gap = gapAround(labelAt(vec3(cell) + mix(a, b, 0.5 * (from + to))), bernstein(along, from));
    vec4 part = bernsteinBetween(along, from, to);
    float u = leavesHull(part, gap.x, gap.y) ? firstExit(part, gap.x, gap.y) : 2.0;
    if (u <= 1.0) found = mix(from, to, u);
    from = to;
  } while (to < 1.0 && found > 1.0);
  return found;
}
