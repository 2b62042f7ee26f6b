// The volume rendering integral from face to face of the cells along a ray.
//
// Front-to-back compositing (Levoy 1988): C ← C + (1 - A) c, A ← A + (1 - A) a, with the colour c and opacity a of one
// segment. A segment runs from the face by which the ray enters a cell to the face by which it leaves. Over it values are
// taken to change evenly, and the transfer function is integrated over them, not sampled (lib/integral/Piece.glsl). A
// point on a face lies between four voxels, where a point inside a cell lies between eight; and the ray meets the bends
// of the trilinear field, which are at the faces, at every one. The error is of second order in the cells' size.
//
// WHOLE_CELLS: all eight corners of a cell are read, once, as lit pictures need them: light turns most within a cell. A
// segment has two halves then, which meet in what the volume holds in its middle, and its light is taken in three places.
// A ray that only grazes a surface, outside at both faces, meets it in the middle.
#include <focus>
#include <light>
#include <opening>
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/FaintLabels.glsl"
#include "lib/PreIntegration.glsl"
#include "lib/TransferTables.glsl"
#include "lib/Traversal.glsl"
#include "lib/Volume.glsl"
#include "lib/integral/CellField.glsl"
#include "lib/integral/LightPlaces.glsl"
#include "lib/integral/Piece.glsl"
#include "lib/integral/Settings.glsl"

#ifndef BENT_NORMALS
#define BENT_NORMALS 0
#endif

// Where a ray is, and what the volume holds there.
struct RayPoint {
  float s;       // mm along the ray
  float stored;
  float entry;   // of the value in the tables
  vec3 gated;    // normal
#if OCCLUDED
  vec2 open;     // what is left of ambient and of direct light
#endif
};

// The state of a ray's walk. No member is a bool: lavapipe refuses local arrays that hold one.
struct Walk {
  Ray ray;
  Cut cut;
  ivec3 upwards;
  Block block;            // ahead of the ray
  uint slot;              // of the focus, in that block
  uint functions;         // of the context, in that block's first cell
  RayPoint front, back;   // of the segment crossed last
#if WHOLE_CELLS
  CellField field;        // of that segment's cell
#endif
  vec4 result;            // colour and opacity so far, premultiplied
  vec4 last;              // of the last segment that shows anything to speak of
  int left;               // 1: the ray goes on
};

// Early ray termination: what lies behind the last segment can no longer be seen.
bool goesOn(Walk walk) { return walk.left != 0; }
bool isWhole(Walk walk) { return walk.slot == 0u && walk.functions == 0u; }
// Whether the segment ahead may have parts: in the focus, or of other functions than the volume's.
bool mayHaveParts(Walk walk) { return goesOn(walk) && !isWhole(walk); }

// At a face by which the ray enters `cell`. From cell to cell the sum of the indices changes by one, whatever is skipped,
// so the bounds of neighbouring faces lie at least LEAST_SPAN apart.
void classify(inout RayPoint point, ivec3 cell) {
  float phase = LEAST_SPAN * float((cell.x + cell.y + cell.z) & 1);
  point.entry = entryNear(entryOf(point.stored), phase);
}

vec3 withinCell(Ray ray, ivec3 cell, float s) { return clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0); }

// Bilinear between the face's four voxels.
RayPoint pointOnFace(Walk walk, Face face) {
  vec3 w = withinCell(walk.ray, face.cell, face.s);
  ivec3 low = max(face.cell - 1, ivec3(0)), high = min(face.cell, volume.dims - 1);
  ivec3 met = mix(low, high, bvec3(walk.upwards));
  bvec3 across = bvec3(face.across);
  low = mix(low, met, across);
  high = mix(high, met, across);
  // The face's own axes are the first and the last of those that the ray does not cross.
  float along = across.x ? w.y : w.x, aside = across.z ? w.y : w.z;
  ivec3 voxels[4] = ivec3[4](low, ivec3(high.x, across.x ? high.y : low.y, low.z),
                             ivec3(low.x, across.z ? high.y : low.y, high.z), high);
  RayPoint point;
  point.s = face.s;
  vec4 texels = vec4(texelOf(volumeTexels, voxels[0]).r, texelOf(volumeTexels, voxels[1]).r,
                     texelOf(volumeTexels, voxels[2]).r, texelOf(volumeTexels, voxels[3]).r);
  vec2 edges = mix(texels.xz, texels.yw, along);
  point.stored = TEXEL_SCALE * mix(edges.x, edges.y, aside);
  point.gated = mix(mix(gatedAt(voxels[0]), gatedAt(voxels[1]), along),
                    mix(gatedAt(voxels[2]), gatedAt(voxels[3]), along), aside);
#if OCCLUDED
  point.open = openAt(cellPosition(walk.ray, face.s));
#endif
  return point;
}

// The gated normal inside a cell, trilinear.
vec3 gatedInside(Ray ray, ivec3 cell, float s) {
  vec3 w = withinCell(ray, cell, s), gated = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    vec3 weights = mix(1.0 - w, w, bvec3(cornerOf(i)));
    gated += weights.x * weights.y * weights.z * gatedAt(cell - 1 + cornerOf(i));
  }
  return gated;
}

// Trilinear between the cell's eight texels, also of a spline, as points on faces are bilinear between four.
RayPoint pointInside(Ray ray, ivec3 cell, float s) {
  RayPoint point;
  point.s = s;
  point.stored = storedBetween(cellPosition(ray, s));
  point.gated = gatedInside(ray, cell, s);
#if OCCLUDED
  point.open = openAt(cellPosition(ray, s));
#endif
  return point;
}

// Part of the way from one point to another.
RayPoint between(RayPoint front, RayPoint back, float u) {
  RayPoint point;
  point.s = mix(front.s, back.s, u);
  point.stored = mix(front.stored, back.stored, u);
  point.entry = entryOf(point.stored);
  point.gated = mix(front.gated, back.gated, u);
#if OCCLUDED
  point.open = mix(front.open, back.open, u);
#endif
  return point;
}

vec4 meanOfContext(RayPoint front, RayPoint back) {
  return meanMaterial(contextTable(), boundAt(contextTable(), front.entry), boundAt(contextTable(), back.entry));
}

// Premultiplied colour and opacity of one material from one point to another, lit as at the centre of its emission.
vec4 pieceBetween(Walk walk, RayPoint front, RayPoint back, vec4 material, bool ofFocus) {
  float size = back.s - front.s, u = centreOfEmission(material.a * size), s = front.s + u * size;
  vec3 gated = mix(front.gated, back.gated, u);
  vec2 light = ofFocus ? lightOfFocus(gated, cellPosition(walk.ray, s), walk.ray.world)
                       : lightOfGated(gated, walk.ray.world);
  light = behindCut(light, walk.cut, s);
#if OCCLUDED
  light = occluded(light, mix(front.open, back.open, u));
#endif
  return pieceOf(material, size, light);
}

// Over so many mm from one entry of lib/PreIntegration.glsl to a different one.
Segment segmentBetween(float front, float back, float size) {
  bool rises = back > front;
  float perEntry = size / abs(back - front);
  Level level = levelOf(perEntry);
  vec4 seenInFront = seenFrom(front, rises, level), seenBehind = seenFrom(back, rises, level);
  return segmentOver(front, seenInFront, back, seenBehind, perEntry, level);
}

#if WHOLE_CELLS
// At a position within the cell that the last segment is in.
RayPoint pointIn(Walk walk, vec3 w, float s) {
  RayPoint point;
  point.s = s;
  point.stored = storedIn(walk.field, w);
  point.gated = gatedIn(walk.field, w);
#if OCCLUDED
  point.open = openAt(cellPosition(walk.ray, s));
#endif
  return point;
}

// At part `u` of the way through a cell, from `a` to `b` within it.
vec2 lightIn(Walk walk, vec3 a, vec3 b, float u) {
  vec2 light = behindCut(lightOfGated(gatedIn(walk.field, mix(a, b, u)), walk.ray.world), walk.cut,
                         mix(walk.front.s, walk.back.s, u));
#if OCCLUDED
  light = occluded(light, mix(walk.front.open, walk.back.open, u));
#endif
  return light;
}

// Of the context, over the last segment.
vec4 contextPiece(Walk walk, ivec3 cell) {
  RayPoint front = walk.front, back = walk.back;
  vec3 a = withinCell(walk.ray, cell, front.s), b = withinCell(walk.ray, cell, back.s);
  float middle = entryBetween(entryOf(storedIn(walk.field, 0.5 * (a + b)))), size = 0.5 * (back.s - front.s);
  Segment first = segmentBetween(front.entry, middle, size), second = segmentBetween(middle, back.entry, size);
  LightPlaces places = lightPlaces(first, second);
  vec2 minor = lightIn(walk, a, b, places.minor);
  vec2 major = mix(lightIn(walk, a, b, places.major.y), lightIn(walk, a, b, places.major.x), places.share);
  return over(litBy(first.piece, places.behind ? minor : major), litBy(second.piece, places.behind ? major : minor));
}
#else
// Of the context, over the last segment. Lit, it is one of a refined grid, short enough for one light, taken at the centre
// of its emission.
vec4 contextPiece(Walk walk, ivec3 cell) {
  RayPoint front = walk.front, back = walk.back;
  Segment segment = segmentBetween(front.entry, back.entry, back.s - front.s);
  if (!LIT) return segment.piece;
  float u = centreOfEmission(segment.depth), s = mix(front.s, back.s, u);
  vec2 light = behindCut(lightOfGated(mix(front.gated, back.gated, u), walk.ray.world), walk.cut, s);
#if OCCLUDED
  light = occluded(light, mix(front.open, back.open, u));
#endif
  return litBy(segment.piece, light);
}
#endif

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
  if (walk.cut.onFocus != 0u && walk.front.s == walk.cut.start) field.x = ontoFocus(field.x, range);
  if (range.x > -FAR) part = partAbove(field, range.x);
  if (range.y < FAR) {
    vec2 below = partAbove(-field, -range.y);
    part = vec2(max(part.x, below.x), min(part.y, below.y));
  }
  return part;
}

#if FOCUS_FUNCTIONS
// Mean material of the focus from one point to another. `function`: as focusTable() has it; `material`: where there is none.
vec4 meanInFocus(RayPoint front, RayPoint back, vec4 function, vec4 material) {
  Table table = tableFrom(int(function.x));
  Bound first = boundAt(table, front.stored * function.y + function.z);
  Bound last = boundAt(table, back.stored * function.y + function.z);
  return mix(material, meanWithoutBranch(table, first, last), bvec4(function.x > 0.0));
}
#endif

// Half way between two points of a segment in the focus. BENT_NORMALS: the normals of all three are on the parabola through
// the exact one in the middle of the segment. Those of the volume turn fast at the surface of a focus of values.
RayPoint halfWayInFocus(Walk walk, ivec3 cell, inout RayPoint enters, inout RayPoint leavesAt) {
  RayPoint halfWay = between(enters, leavesAt, 0.5);
#if BENT_NORMALS
  float size = walk.back.s - walk.front.s;
  vec3 bend = 4.0 * gatedInside(walk.ray, cell, 0.5 * (walk.front.s + walk.back.s)) -
              2.0 * (walk.front.gated + walk.back.gated);
  vec3 u = (vec3(enters.s, halfWay.s, leavesAt.s) - walk.front.s) / max(size, 1e-30), weights = u * (1.0 - u);
  enters.gated += weights.x * bend;
  halfWay.gated += weights.y * bend;
  leavesAt.gated += weights.z * bend;
#endif
  return halfWay;
}

// What of a segment is in the focus. By value it is lit in two halves, as the context is; so is a focus of values in normal
// quality.
vec4 pieceInFocus(Walk walk, ivec3 cell, RayPoint enters, RayPoint leavesAt) {
  vec3 middle = cellPosition(walk.ray, 0.5 * (enters.s + leavesAt.s));
  vec4 material = focusMaterial(middle);
#if FOCUS_FUNCTIONS
  vec4 function = focusTable(middle);
  if (LIT) {
    RayPoint halfWay = halfWayInFocus(walk, cell, enters, leavesAt);
    return over(pieceBetween(walk, enters, halfWay, meanInFocus(enters, halfWay, function, material), true),
                pieceBetween(walk, halfWay, leavesAt, meanInFocus(halfWay, leavesAt, function, material), true));
  }
  material = meanInFocus(enters, leavesAt, function, material);
#elif BENT_NORMALS
  if (LIT) {
    RayPoint halfWay = halfWayInFocus(walk, cell, enters, leavesAt);
    return over(pieceBetween(walk, enters, halfWay, material, true),
                pieceBetween(walk, halfWay, leavesAt, material, true));
  }
#endif
  return pieceBetween(walk, enters, leavesAt, material, true);
}

#if FAINT_LABELS
// Of the context from one point in a cell to another, by one of its functions.
vec4 pieceByFunction(Walk walk, RayPoint front, RayPoint back, int function) {
  Table table = tableFrom(2 * function);
  vec4 mean = meanWithoutBranch(table, boundAt(table, front.entry), boundAt(table, back.entry));
  return pieceBetween(walk, front, back, mean, false);
}

// Of the context from one point in a cell to another. Each function's part is lit in two halves, as contextPiece() is.
vec4 contextBetween(Walk walk, ivec3 cell, RayPoint front, RayPoint back) {
  vec3 a = clamp(cellPosition(walk.ray, front.s) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(walk.ray, back.s) - vec3(cell), 0.0, 1.0);
  RayPoint begin = front, end;
  float from = 0.0, to = 0.0;
  vec4 result = vec4(0.0);
  do {
    to = nextFunction(a, b, from);
    end = between(front, back, to);
    int function = functionAt(vec3(cell) + mix(a, b, 0.5 * (from + to)));
    RayPoint middle = between(begin, end, 0.5);
    if (LIT)
      result = over(result, over(pieceByFunction(walk, begin, middle, function),
                                 pieceByFunction(walk, middle, end, function)));
    else
      result = over(result, pieceByFunction(walk, begin, end, function));
    begin = end;
    from = to;
  } while (to < 1.0);
  return result;
}
#else
vec4 contextBetween(Walk walk, ivec3 cell, RayPoint front, RayPoint back) {
  return pieceBetween(walk, front, back, meanOfContext(front, back), false);
}
#endif

// A segment that is partly in the focus, or in which the context's functions differ: what lies before, in and behind the
// focus.
vec4 focusPiece(Walk walk, ivec3 cell, vec2 part) {
  RayPoint front = walk.front, back = walk.back;
  RayPoint enters = between(front, back, part.x), leavesAt = between(front, back, max(part.x, part.y));
  vec4 before = contextBetween(walk, cell, front, enters);
  vec4 inside = pieceInFocus(walk, cell, enters, leavesAt);
  vec4 behind = contextBetween(walk, cell, leavesAt, back);
  return over(over(before, inside), behind);
}

Walk walkFrom(Ray ray, Cut cut, bool visible) {
  Walk walk;
  walk.ray = ray;
  walk.cut = cut;
  walk.upwards = upwardsOf(ray);
  ivec3 cell = cellAt(ray, cut.start);
  walk.block = blockAt(cell, walk.upwards, invisibleAround(cell));
  walk.slot = focusSlot(cell);
  walk.functions = functionsIn(cell);
  walk.back = pointInside(ray, cell, cut.start);
  classify(walk.back, cell);
  walk.front = walk.back;
  walk.result = vec4(0.0);
  walk.last = vec4(0.0);
  walk.left = visible ? 1 : 0;
  return walk;
}

// Whether a ray leaps from one empty block to the next without a look at the values between them. Where rays run in step,
// unlit ones do not: the test costs every step a little, and some ray among them mostly has something to integrate.
const bool LEAPS = LIT || !IN_STEP;
// Whether a ray leaps out of the last empty block, too: a segment that reads its own cell needs nothing from there.
const bool LEAPS_TO_VISIBLE = WHOLE_CELLS == 1;

// The face behind the block ahead, and the block behind that face.
void lookAhead(Walk walk, out Face face, out Block behind) {
  face = faceBehind(walk.block, walk.ray, walk.upwards, walk.back.s);
  ivec3 cell = cellBehind(face, walk.upwards);
  behind = blockAt(cell, walk.upwards, invisibleAround(cell));
}

// The same after leaps over empty blocks. Results pass through an `if`; lib/schedule/Llvmpipe says why.
void leapAhead(inout Walk walk, out Face face, out Block behind) {
  bool leaps = true;
  do {
    if (leaps) {
      lookAhead(walk, face, behind);
      leaps = walk.block.empty != 0 && (LEAPS_TO_VISIBLE || behind.empty != 0) && isInVolume(behind.cell);
      if (leaps) {
        walk.block = behind;
        walk.back.s = face.s;
        if (LEAPS_TO_VISIBLE) walk.slot = focusSlot(behind.cell);
        if (LEAPS_TO_VISIBLE) walk.functions = functionsIn(behind.cell);
      }
    }
  } while (leaps);
}

void composite(inout Walk walk, Block crossed, vec4 piece) {
  if (goesOn(walk) && crossed.empty == 0) {
    walk.result += (1.0 - walk.result.a) * piece;
    if (piece.a > 1e-6) walk.last = piece;
  }
  bool more = goesOn(walk) && isInVolume(walk.block.cell) && 1.0 - walk.result.a >= integral.leastTransmittance;
#if CLIPPED
  more = more && walk.back.s < walk.ray.sOut;
#endif
  walk.left = more ? 1 : 0;
}

// To the face behind the block ahead, or where the ray ends before it.
void crossBlock(inout Walk walk, Face face) {
  ivec3 cell = walk.block.cell;
#if WHOLE_CELLS
  float from = walk.back.s, to = face.s;
#if CLIPPED
  to = min(to, walk.ray.sOut);
#endif
  walk.field = fieldOf(cell);
  walk.front = pointIn(walk, withinCell(walk.ray, cell, from), from);
  walk.back = pointIn(walk, withinCell(walk.ray, cell, to), to);
  classify(walk.front, cell);
#else
  walk.front = walk.back;
  walk.back = pointOnFace(walk, face);
#if CLIPPED
  if (face.s > walk.ray.sOut) walk.back = pointInside(walk.ray, cell, walk.ray.sOut);
#endif
#endif
}

// Every ray comes to the block that its next step crosses.
void comeToNext(inout Walk walks[RAYS], out Face faces[RAYS], out Block behind[RAYS]) {
  for (int i = 0; i < RAYS; ++i) {
    if (LEAPS)
      leapAhead(walks[i], faces[i], behind[i]);
    else
      lookAhead(walks[i], faces[i], behind[i]);
  }
}

// Every ray takes a step, through the block ahead of it. `parts`: false where no segment ahead may have parts.
//
// The rays take each part of the step together, so that one has instructions to run while the other waits for memory.
void takeStep(inout Walk walks[RAYS], Face faces[RAYS], Block behind[RAYS], const bool parts) {
  Block crossed[RAYS];
  uint slots[RAYS], isOne[RAYS];
  for (int i = 0; i < RAYS; ++i) crossBlock(walks[i], faces[i]);
  for (int i = 0; i < RAYS; ++i) classify(walks[i].back, behind[i].cell);
  for (int i = 0; i < RAYS; ++i) {
    crossed[i] = walks[i].block;
    slots[i] = walks[i].slot;
    isOne[i] = isWhole(walks[i]) ? 1u : 0u;
    walks[i].block = behind[i];
    walks[i].slot = focusSlot(behind[i].cell);
    walks[i].functions = functionsIn(behind[i].cell);
  }
  for (int i = 0; i < RAYS; ++i) {
    vec4 piece;
    if (parts && isOne[i] == 0u)
      piece = focusPiece(walks[i], crossed[i].cell, focusPart(walks[i], slots[i], crossed[i].cell));
    else
      piece = contextPiece(walks[i], crossed[i].cell);
    composite(walks[i], crossed[i], piece);
  }
}

bool anyGoesOn(Walk walks[RAYS]) {
  bool any = false;
  for (int i = 0; i < RAYS; ++i) any = any || goesOn(walks[i]);
  return any;
}

bool anyHasParts(Walk walks[RAYS]) {
  bool any = false;
  for (int i = 0; i < RAYS; ++i) any = any || mayHaveParts(walks[i]);
  return any;
}

void integrate(inout Walk walks[RAYS]) {
  const bool parts = HAS_FOCUS || HAS_FAINT;
  Face faces[RAYS];
  Block behind[RAYS];
  do {
    comeToNext(walks, faces, behind);
    // A segment that may have parts costs more than one that has none: rays that run in step wait there for each other.
    if (IN_STEP && parts) {
      do {
        if (anyHasParts(walks)) break;
        takeStep(walks, faces, behind, false);
        comeToNext(walks, faces, behind);
      } while (anyGoesOn(walks));
    }
    takeStep(walks, faces, behind, parts);
  } while (anyGoesOn(walks));
}

// What a terminated ray has not come to is taken to look like its last segment in lit pictures, and half of it like the
// ray so far in unlit ones, whose other errors are no greater than that.
vec4 colourOf(Walk walk) {
  float transmittance = 1.0 - walk.result.a;
  if (transmittance >= integral.leastTransmittance) return walk.result;
  return LIT ? walk.result + transmittance / walk.last.a * walk.last : compensateTermination(walk.result);
}
