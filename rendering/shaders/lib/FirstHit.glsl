// First hit of the focus, or of the context, along a ray.
//
// A search goes through stages, each more expensive than the one before: leap to a cell that may hold a hit; look whether
// the hull of the field along the ray in that cell reaches out of the gap of values that the ray has to leave; solve for
// the point where the field does. Where neighbouring rays run in step, a ray waits until all of them need the next stage.
#include <clip>
#include <focus>
#include <translucent>
#include <look>
#include <schedule>
#include <volume>
#include "lib/Search.glsl"
#include "lib/Traversal.glsl"

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
  if (GREY_FACES && ray.cap >= 0) return ray.sIn;  // an opaque face
  if (HAS_FAINT) return firstHit(false, true, ray, ray.sIn, sEnd, vec2(0.0));
  // The field is continuous: a ray that starts inside one transparent gap of values can leave that gap only through its ends.
  float value = storedExact(cellPosition(ray, ray.sIn));
  for (int i = 0; i < gapCount; ++i)
    if (value > gaps[i].x && value < gaps[i].y) return firstHit(false, true, ray, ray.sIn, sEnd, gaps[i]);
  return ray.sIn;
}
