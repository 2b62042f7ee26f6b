// First hit of the focus, or of the context, along a ray.
//
// A search goes through stages, each more expensive than the one before: leap to a cell that may hold a hit; look whether
// the hull of the field along the ray in that cell reaches out of the gap of values that the ray has to leave; solve for
// the point where the field does. Where neighbouring rays run in step, a ray waits until all of them need the next stage.
#include <schedule>
#include <focus>
#include "lib/Crossing.glsl"
#include "lib/FaintLabels.glsl"
#include "lib/Traversal.glsl"
#include "lib/Volume.glsl"

// Where there is none of the focus, and where the context is transparent, as emptyAround() reads them.
UNSIGNED_TEXELS_3D(r16ui, focusSkip);
UNSIGNED_TEXELS_3D(r16ui, contextSkip);

// Open intervals of stored values in which the context is transparent, for each of its functions (lib/FaintLabels.glsl).
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

// The gap of a function that holds a value; an empty one where none does.
vec2 gapAround(int function, float value) {
  vec2 found = vec2(FAR, -FAR);
  for (int i = 0; i < gapCount; ++i) {
    vec2 gap = gaps[function * gapCount + i];
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

// Of the field along a path within a cell, where the context begins by the functions there: u; 2 where it does not.
float firstContextExit(ivec3 cell, vec3 a, vec3 b, vec4 along) {
  uint functions = functionsIn(cell);
  float from = 0.0, to = 0.0, found = 2.0;
  do {
    to = functionsDiffer(functions) ? nextFunction(a, b, from) : 1.0;
    vec2 gap = gapAround(functionAt(vec3(cell) + mix(a, b, 0.5 * (from + to))), bernstein(along, from));
    vec4 part = bernsteinBetween(along, from, to);
    float u = leavesHull(part, gap.x, gap.y) ? firstExit(part, gap.x, gap.y) : 2.0;
    if (u <= 1.0) found = mix(from, to, u);
    from = to;
  } while (to < 1.0 && found > 1.0);
  return found;
}

#if REFINEMENT > 1
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
#else
void look(inout Search search, const bool ofFocus, Ray ray, float sEnd) {
  ivec3 cell = search.cell;
  search.sFrom = search.s;
  moveOn(search, ray, sEnd, blockAt(cell, search.upwards, 0));
  search.sTo = min(search.s, sEnd);
  vec3 a = clamp(cellPosition(ray, search.sFrom) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(ray, search.sTo) - vec3(cell), 0.0, 1.0);
  float f[8];
  cellCorners(cell, f);
  search.along = bernsteinAlong(f, a, b);
  if (ofFocus) {
    search.along = focusAlong(focusCellAt(focusSlot(cell), cell), a, b, search.along);
    search.gap = gapAround(search.along.x);
  }
  search.after = search.stage;
  if (HAS_FAINT && !ofFocus) {
    float u = firstContextExit(cell, a, b, search.along);
    if (u <= 1.0) search.hit = mix(search.sFrom, search.sTo, u);
    if (u <= 1.0) search.stage = ENDED;
  } else if (leavesHull(search.along, search.gap.x, search.gap.y)) {
    search.stage = SOLVE;
  }
}
#endif

// `exact`: for the point itself; otherwise for the cell that it lies in.
void solve(inout Search search, const bool exact) {
  vec2 gap = search.gap, piece;
  float u = exact ? firstExit(search.along, gap.x, gap.y) : leaves(search.along, gap.x, gap.y, piece) ? 0.0 : 2.0;
  search.stage = u <= 1.0 ? ENDED : search.after;
  if (u <= 1.0) search.hit = mix(search.sFrom, search.sTo, u);
}

// From sBegin to sEnd; NONE where there is none. `gap`: of the context, the interval that it has to leave.
float firstHit(const bool ofFocus, const bool exact, Ray ray, float sBegin, float sEnd, vec2 gap) {
  if (sBegin > sEnd) return NONE;
  Search search;
  search.upwards = upwardsOf(ray);
  search.cell = cellAt(ray, sBegin);
  search.s = sBegin;
  search.stage = LEAP;
  search.after = ENDED;
  search.sFrom = search.sTo = sBegin;
  search.along = vec4(0.0);
  search.gap = gap;
  search.hit = NONE;
  do {
    do {
      do leap(search, ofFocus, ray, sEnd); while (IN_STEP && search.stage == LEAP);
      if (search.stage == LOOK) look(search, ofFocus, ray, sEnd);
    } while (IN_STEP && search.stage == LEAP);
    if (search.stage == SOLVE) solve(search, exact);
  } while (search.stage != ENDED);
  return search.hit;
}

float firstFocusHit(Ray ray) { return HAS_FOCUS ? firstHit(true, true, ray, ray.sIn, ray.sOut, vec2(0.0)) : NONE; }
bool meetsFocus(Ray ray) { return HAS_FOCUS && !isNone(firstHit(true, false, ray, ray.sIn, ray.sOut, vec2(0.0))); }

// First context point in [sIn, sEnd].
float firstContextHit(Ray ray, float sEnd) {
  if (ray.sIn > sEnd) return NONE;
#if CLIPPED == 2
  if (ray.cap >= 0) return ray.sIn;  // an opaque face
#endif
#if FAINT_LABELS
  return firstHit(false, true, ray, ray.sIn, sEnd, vec2(0.0));
#else
  // The field is continuous: a ray that starts inside one transparent gap of values can leave that gap only through its ends.
  float value = storedExact(cellPosition(ray, ray.sIn));
  for (int i = 0; i < gapCount; ++i)
    if (value > gaps[i].x && value < gaps[i].y) return firstHit(false, true, ray, ray.sIn, sEnd, gaps[i]);
  return ray.sIn;
#endif
}
