// A segment that is partly in the focus, or of translucent labels.
#include <colours>
#include <focus>
#include <translucent>
#include <light>
#include <volume>
#include "lib/Crossing.glsl"
#include "lib/TransferTables.glsl"
#include "lib/integral/FaceWalk.glsl"
#include "lib/integral/Settings.glsl"

// Whether all of a segment has the value at which the focus ends, within the rounding of filtered texels. A whole region may
// have it, and belongs to the focus.
bool isAt(vec3 field, float end) {
  const float ROUNDING = 4e-6;  // 32 units in the last place
  return all(lessThanEqual(abs(field - end), vec3(ROUNDING * abs(end))));
}

// The part of the last segment that is in the focus, as partAbove() has it: the focus's field runs as a parabola through
// its exact value in the middle.
vec2 focusPart(Walk walk, uint slot, ivec3 cell) {
  FocusCell held = focusCellAt(slot, cell);
  if (!mayHoldFocus(held)) return vec2(1.0, 0.0);
  float s[3] = float[3](walk.front.s, 0.5 * (walk.front.s + walk.back.s), walk.back.s);
  float stored[3] = float[3](walk.front.stored, storedBetween(cellPosition(walk.ray, s[1])), walk.back.stored);
  vec3 field;
  for (int i = 0; i < 3; ++i)
    field[i] = focusAt(held, clamp(cellPosition(walk.ray, s[i]) - vec3(cell), 0.0, 1.0), stored[i]);
  vec2 range = focusRange(), part = vec2(0.0, 1.0);
  if (isAt(field, range.x) || isAt(field, range.y)) return part;
  if (walk.cut.onFocus != 0u && walk.front.s == walk.cut.start) field.x = ontoFocus(field.x, range);
  if (range.x > -FAR) part = partAbove(field, range.x);
  if (range.y < FAR) {
    vec2 below = partAbove(-field, -range.y);
    part = vec2(max(part.x, below.x), min(part.y, below.y));
  }
  return part;
}

// Mean material of the focus from one point to another. `function`: as focusTable() has it; `material`: where there is none.
vec4 meanInFocus(RayPoint front, RayPoint back, vec4 function, vec4 material) {
  Table table = tableFrom(int(function.x));
  Bound first = boundAt(table, front.stored * function.y + function.z);
  Bound last = boundAt(table, back.stored * function.y + function.z);
  return mix(material, meanWithoutBranch(table, first, last), bvec4(function.x > 0.0));
}

vec4 meanOfContext(RayPoint front, RayPoint back) {
  return meanMaterial(contextTable(), boundAt(contextTable(), front.entry), boundAt(contextTable(), back.entry));
}

// Half way between two points of a segment in the focus. BENT_NORMALS: the normals of all three are on the parabola through
// the exact one in the middle of the segment. Those of the volume turn fast at the surface of a focus of values.
RayPoint halfWayInFocus(Walk walk, ivec3 cell, inout RayPoint enters, inout RayPoint leavesAt) {
  RayPoint halfWay = between(enters, leavesAt, 0.5);
  if (BENT_NORMALS == 0) return halfWay;
  float size = walk.back.s - walk.front.s;
  vec3 bend = 4.0 * gatedInside(walk.ray, cell, 0.5 * (walk.front.s + walk.back.s)) -
              2.0 * (walk.front.gated + walk.back.gated);
  vec3 u = (vec3(enters.s, halfWay.s, leavesAt.s) - walk.front.s) / max(size, 1e-30), weights = u * (1.0 - u);
  enters.gated += weights.x * bend;
  halfWay.gated += weights.y * bend;
  leavesAt.gated += weights.z * bend;
  return halfWay;
}

// What of a segment is in the focus. By value it is lit in two halves, as the context is; so is a focus of values in normal
// quality.
vec4 pieceInFocus(Walk walk, ivec3 cell, RayPoint enters, RayPoint leavesAt) {
  vec3 middle = cellPosition(walk.ray, 0.5 * (enters.s + leavesAt.s));
  vec4 material = focusMaterial(middle);
  if (FOCUS_BY_VALUE) {
    vec4 function = focusTable(middle);
    if (LIT) {
      RayPoint halfWay = halfWayInFocus(walk, cell, enters, leavesAt);
      return over(pieceBetween(walk, enters, halfWay, meanInFocus(enters, halfWay, function, material), true),
                  pieceBetween(walk, halfWay, leavesAt, meanInFocus(halfWay, leavesAt, function, material), true));
    }
    material = meanInFocus(enters, leavesAt, function, material);
  } else if (LIT && BENT_NORMALS == 1) {
    RayPoint halfWay = halfWayInFocus(walk, cell, enters, leavesAt);
    return over(pieceBetween(walk, enters, halfWay, material, true),
                pieceBetween(walk, halfWay, leavesAt, material, true));
  }
  return pieceBetween(walk, enters, leavesAt, material, true);
}

vec4 shownInFocus(inout Walk walk, ivec3 cell, RayPoint enters, RayPoint leavesAt) {
  vec4 piece = pieceInFocus(walk, cell, enters, leavesAt);
  if (!HAS_BODIES) return piece;
  Label label = focusLabel(cellPosition(walk.ray, 0.5 * (enters.s + leavesAt.s)));
  return shownOf(walk.bodies, label, piece, enters.s, leavesAt.s);
}

// What shows of the focus from one point in a cell to another. Where labels have materials of their own, each stretch has that
// of its nearest voxel: an opaque label hides what follows within a part of the cell.
vec4 focusBetween(inout Walk walk, ivec3 cell, RayPoint enters, RayPoint leavesAt) {
  if (!MANY_COLOURS) return shownInFocus(walk, cell, enters, leavesAt);
  vec3 a = clamp(cellPosition(walk.ray, enters.s) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(walk.ray, leavesAt.s) - vec3(cell), 0.0, 1.0);
  RayPoint begin = enters, end;
  float from = 0.0, to = 0.0;
  vec4 result = vec4(0.0);
  do {
    to = nextColour(a, b, from);
    end = between(enters, leavesAt, to);
    result = over(result, shownInFocus(walk, cell, begin, end));
    begin = end;
    from = to;
  } while (to < 1.0);
  return result;
}

vec4 pieceOfContext(Walk walk, RayPoint front, RayPoint back) {
  vec4 mean = meanWithoutBranch(contextTable(), boundAt(contextTable(), front.entry), boundAt(contextTable(), back.entry));
  return pieceBetween(walk, front, back, mean, false);
}

// What shows of the context from one point in a cell to another. Where labels are translucent, the part of each is lit in two
// halves, as contextPiece() is.
vec4 contextBetween(inout Walk walk, ivec3 cell, RayPoint front, RayPoint back) {
  if (!HAS_FAINT) return pieceBetween(walk, front, back, meanOfContext(front, back), false);
  vec3 a = clamp(cellPosition(walk.ray, front.s) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(walk.ray, back.s) - vec3(cell), 0.0, 1.0);
  RayPoint begin = front, end;
  float from = 0.0, to = 0.0;
  vec4 result = vec4(0.0);
  do {
    to = nextLabel(a, b, from);
    end = between(front, back, to);
    int number = labelAt(vec3(cell) + mix(a, b, 0.5 * (from + to)));
    Label label = number > 0 ? Label(number, opacityOf(number)) : noLabel();
    RayPoint middle = between(begin, end, 0.5);
    vec4 piece = vec4(0.0);
    if (LIT) piece = over(pieceOfContext(walk, begin, middle), pieceOfContext(walk, middle, end));
    else piece = pieceOfContext(walk, begin, end);
    result = over(result, shownOf(walk.bodies, label, piece, begin.s, end.s));
    begin = end;
    from = to;
  } while (to < 1.0);
  return result;
}

// A segment that is partly in the focus, or of translucent labels: what lies before, in and behind the focus.
vec4 focusPiece(inout Walk walk, ivec3 cell, vec2 part) {
  RayPoint front = walk.front, back = walk.back;
  RayPoint enters = between(front, back, part.x), leavesAt = between(front, back, max(part.x, part.y));
  vec4 before = contextBetween(walk, cell, front, enters);
  vec4 inside = focusBetween(walk, cell, enters, leavesAt);
  vec4 behind = contextBetween(walk, cell, leavesAt, back);
  return over(over(before, inside), behind);
}
