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

// Chebyshev distance in bricks to the nearest one where the context is not transparent.
UNSIGNED_TEXELS_3D(r8ui, contextSkip);

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
  float sFrom;  // where the ray came into the cell looked into; it leaves that at s
  vec4 along;   // the field in it, Bernstein coefficients
  vec2 gap;     // open interval that the field has to leave
#if FAINT_LABELS
  ivec3 within;    // the cell looked into
  vec3 a, b;       // both ends of the ray's path in it, 0 to 1
  uint functions;  // in it
#endif
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
  int empty = ofFocus ? distanceToFocus(brick) : int(texelOf(contextSkip, brick).r);
  bool found = empty == 0;
  if (ofFocus) found = found && mayHoldFocus(focusCellAt(focusSlot(search.cell), search.cell));
  if (found)
    search.stage = LOOK;
  else
    moveOn(search, ray, sEnd, blockAt(search.cell, search.upwards, empty));
}

void look(inout Search search, const bool ofFocus, Ray ray, float sEnd) {
  ivec3 cell = search.cell;
  search.sFrom = search.s;
  moveOn(search, ray, sEnd, blockAt(cell, search.upwards, 0));
  vec3 a = clamp(cellPosition(ray, search.sFrom) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(ray, min(search.s, sEnd)) - vec3(cell), 0.0, 1.0);
  float f[8];
  cellCorners(cell, f);
  search.along = bernsteinAlong(f, a, b);
  if (ofFocus) {
    search.along = focusAlong(focusCellAt(focusSlot(cell), cell), a, b, search.along);
    // A ray that comes into the cell inside the focus has met it there: no value lies in the empty gap.
    vec2 range = focusRange();
    float first = search.along.x;
    search.gap = first < range.x ? vec2(-FAR, range.x) : first > range.y ? vec2(range.y, FAR) : vec2(FAR, -FAR);
  }
  search.after = search.stage;
#if FAINT_LABELS
  if (!ofFocus) {
    search.within = cell;
    search.a = a;
    search.b = b;
    search.functions = functionsIn(cell);
    // Where they differ: as if the field left every gap.
    bool differ = functionsDiffer(search.functions);
    search.gap = gapAround(differ ? 0 : int(search.functions), search.along.x);
    search.gap = mix(search.gap, vec2(FAR, -FAR), bvec2(differ));
  }
#endif
  if (leavesHull(search.along, search.gap.x, search.gap.y)) search.stage = SOLVE;
}

#if FAINT_LABELS
// Of a cell in which functions differ: u where the context begins; 2 where it does not.
float firstFaintExit(Search search) {
  float from = 0.0, to = 0.0, found = 2.0;
  do {
    to = nextFunction(search.a, search.b, from);
    vec3 middle = vec3(search.within) + mix(search.a, search.b, 0.5 * (from + to));
    vec2 gap = gapAround(functionAt(middle), bernstein(search.along, from));
    float u = firstExit(bernsteinBetween(search.along, from, to), gap.x, gap.y);
    if (u <= 1.0) found = mix(from, to, u);
    from = to;
  } while (to < 1.0 && found > 1.0);
  return found;
}
#endif

// `exact`: for the point itself; otherwise for the cell that it lies in.
void solve(inout Search search, const bool ofFocus, const bool exact, float sEnd) {
  vec2 gap = search.gap, piece;
  float u = exact ? firstExit(search.along, gap.x, gap.y) : leaves(search.along, gap.x, gap.y, piece) ? 0.0 : 2.0;
#if FAINT_LABELS
  if (!ofFocus && functionsDiffer(search.functions)) u = firstFaintExit(search);
#endif
  search.stage = u <= 1.0 ? ENDED : search.after;
  if (u <= 1.0) search.hit = mix(search.sFrom, min(search.s, sEnd), u);
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
  search.sFrom = sBegin;
  search.along = vec4(0.0);
  search.gap = gap;
#if FAINT_LABELS
  search.within = search.cell;
  search.functions = 0u;
  search.a = search.b = vec3(0.0);
#endif
  search.hit = NONE;
  do {
    do {
      do leap(search, ofFocus, ray, sEnd); while (IN_STEP && search.stage == LEAP);
      if (search.stage == LOOK) look(search, ofFocus, ray, sEnd);
    } while (IN_STEP && search.stage == LEAP);
    if (search.stage == SOLVE) solve(search, ofFocus, exact, sEnd);
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
