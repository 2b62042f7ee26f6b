// A search looks into a cell of trilinear values.
//
// SplineCell.glsl has the same interface; `#include <look>` names the one that the scene needs:
//   look  looks whether the field leaves the gap in the cell ahead, and moves on to what lies behind that
#include <focus>
#include <translucent>
#include <volume>
#include "lib/Crossing.glsl"
#include "lib/Search.glsl"

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
