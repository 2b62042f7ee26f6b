// The volume rendering integral cell by cell, within a bound on its error.
//
// In a cell the values along a ray are a cubic, known exactly from the eight corners with full float weights. The cubic is
// cut where it meets the nodes of the transfer function. Over a part between two cuts colour and extinction are linear in
// the value, so the part's optical depth is exact. Left to approximate is the mean of colour and light over the part,
// weighted by what is seen of it: it is taken to second order in the position, from the weight's mean and variance. Its
// error is estimated beforehand and falls at least as 1/n² with n pieces; a part is cut into as many as the bound asks for.
//
// A walk goes through stages, each more expensive than the one before: leap to a cell that is not empty; look into it;
// integrate it. Where neighbouring rays run in step, a ray waits until all of them need the next stage.
#include <focus>
#include <light>
#include <opening>
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/FaintLabels.glsl"
#include "lib/TransferSegments.glsl"
#include "lib/Traversal.glsl"
#include "lib/Volume.glsl"
#include "lib/integral/Piece.glsl"
#include "lib/integral/Settings.glsl"

const int MOST_PIECES = 64;  // of a part
const int MOST_PARTS = 256;  // of a cell

// What a ray finds between two faces of a cell. Vectors of four are Bernstein coefficients along it.
struct CellPath {
  ivec3 cell;
  vec3 a, b;          // both ends within the cell, 0 to 1
  float sFrom, sTo;   // mm along the ray
  vec4 entries;       // table entries of the values
  vec4 focusAlong;    // the focus's field, where some of the path may be in the focus
#if FOCUS_FUNCTIONS
  vec4 stored;        // values
#endif
  uint functions;     // of the context, as functionsIn() has them
};

float lowest(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float highest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// The corners of a cell are numbered in a frame in which the ray runs upwards along every axis. A step along an axis then
// leaves the cell by its upper face, whose corners are the lower corners of the next cell.
ivec3 turned(Ray ray) { return ivec3(lessThanEqual(ray.direction, vec3(0.0))); }

void stepInto(Ray ray, ivec3 cell, int axis, inout float f[8]) {
  // Corner 7 is an upper corner for each axis.
  int upper[4] = int[4](1 << axis, axis < 2 ? 3 : 5, axis < 1 ? 5 : 6, 7);
  float g[4];
  for (int j = 0; j < 4; ++j)
    g[j] = storedAt(cell - 1 + (cornerOf(upper[j]) ^ turned(ray)));
  bool x = axis == 0, y = axis == 1, z = axis == 2;
  f = float[8](x ? f[1] : y ? f[2] : f[4], x ? g[0] : y ? f[3] : f[5], x ? f[3] : y ? g[0] : f[6], z ? f[7] : g[1],
               x ? f[5] : y ? f[6] : g[0], x ? g[2] : y ? f[7] : g[1], x ? f[7] : g[2], g[3]);
}

// The cell that a ray left when it entered `cell` along `axis`.
ivec3 cellBefore(Ray ray, ivec3 cell, int axis) {
  cell[axis] -= ray.direction[axis] > 0.0 ? 1 : -1;
  return cell;
}

// `a` and `b`: ends within the cell, not turned.
vec4 bernsteinTurned(Ray ray, float f[8], vec3 a, vec3 b) {
  bvec3 downwards = bvec3(turned(ray));
  return bernsteinAlong(f, mix(a, 1.0 - a, downwards), mix(b, 1.0 - b, downwards));
}

const int LEAP = 0, LOOK = 1, CONTEXT = 2, SECTIONS = 3, ENDED = 4;  // stages

// Values of the field that are in no focus.
vec4 outsideFocus() { return vec4(focusRange().x > -3e38 ? -3.4e38 : 3.4e38); }

// Fills in what lies between s and sNext, and tells the stage that it needs: SECTIONS where some may be in the focus or
// functions differ, CONTEXT, or LEAP where nothing shows.
// `f`: the cell's corners, turned.
int lookInto(Ray ray, ivec3 cell, float s, float sNext, float f[8], out CellPath path) {
  path.cell = cell;
  path.functions = functionsIn(cell);
  path.sFrom = s;
  path.sTo = sNext;
  path.a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  path.b = clamp(cellPosition(ray, sNext) - vec3(cell), 0.0, 1.0);
  vec4 stored = bernsteinTurned(ray, f, path.a, path.b);
  // Within limits whose squares and differences float32 holds.
  path.entries = clamp(stored * transfer.map.x + transfer.map.y, vec4(-1e12), vec4(1e12));
#if FOCUS_FUNCTIONS
  path.stored = stored;
#endif
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  path.focusAlong = focusAlong(held, path.a, path.b, stored);
  // integrateSections() asks the field also where none of the cell is in the focus.
  if (HAS_FAINT) path.focusAlong = mix(outsideFocus(), path.focusAlong, bvec4(mayHoldFocus(held)));
  vec2 range = focusRange();
  if (mayHoldFocus(held) && lowest(path.focusAlong) <= range.y && highest(path.focusAlong) >= range.x) return SECTIONS;
  if (ONLY_FOCUS) return LEAP;
  vec2 visible = transfer.visibleEntries;
  int shown = functionsDiffer(path.functions) ? SECTIONS : CONTEXT;
  return highest(path.entries) > visible.x && lowest(path.entries) < visible.y ? shown : LEAP;
}

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

// A part of a path that is all in the focus, of one material or function, or all in the context, of one function.
struct Section {
  float uFrom, uTo;  // of the path
  float sFrom, sTo;  // mm along the ray
  vec4 entries;      // of the context's tables, or that of the focus's function
  bool inFocus;
  vec4 material;     // of the focus
#if FOCUS_FUNCTIONS || FAINT_LABELS
  int function;      // of the context, or of the focus; 0 there: one material
#endif
  CellNormals normals;
};

#if FOCUS_FUNCTIONS || FAINT_LABELS
bool isByValue(Section section) { return !section.inFocus || section.function > 0; }
int functionOf(Section section) { return section.function; }

// Chooses the function of a section.
void findFunction(inout Section section, CellPath path, vec3 at) {
  section.function = section.inFocus ? 0 : functionAt(at);
#if FOCUS_FUNCTIONS
  vec4 table = focusTable(at);
  section.function = section.inFocus ? int(table.x) / 2 : section.function;
  vec4 entries = clamp(path.stored * table.y + table.z, vec4(-1e12), vec4(1e12));
  if (section.inFocus && section.function > 0) section.entries = bernsteinBetween(entries, section.uFrom, section.uTo);
#endif
}
#else
bool isByValue(Section section) { return !section.inFocus; }
int functionOf(Section section) { return 0; }
void findFunction(inout Section section, CellPath path, vec3 at) {}
#endif

// A part of a section in one segment of a transfer function.
struct Part {
  float from, to;  // of the section
  vec4 entries;
  Segment segment;
};

Part partBetween(Part part, float u, float v) {
  return Part(mix(part.from, part.to, u), mix(part.from, part.to, v), bernsteinBetween(part.entries, u, v), part.segment);
}

// What a part holds, whatever light falls on it. Positions are 0 to 1 from its front; the weight of a position is the
// light emitted there that gets out of the part's front.
struct Medium {
  float depth;             // optical
  float growth;            // of the extinction from front to back, over its mean: -2 to 2
  float steepness;         // greatest change of the extinction over its mean, 4 at most
  vec2 change;             // of the entries from front to back, and of what bends away from that to the middle, times 4
  float centre, variance;  // of the positions by their weights
  vec3 colour;             // of what is seen
};

Medium mediumOf(Part part, float size) {
  Segment segment = part.segment;
  vec4 e = part.entries;
  float mean = clamp(0.25 * (e.x + e.y + e.z + e.w), segment.low, segment.high);
  Medium medium;
  // The best line's slope is 12 times the first moment of the cubic; what is left is nearly q (u² - u + 1/6).
  medium.change = vec2(0.3 * (3.0 * (e.w - e.x) + e.z - e.y), 1.5 * (e.x - e.y - e.z + e.w));
  float extinction = max(segment.material.a + segment.slope.a * (mean - segment.anchor), 0.0);
  medium.depth = extinction * size;
  float slope = segment.slope.a / max(extinction, 1e-30);
  medium.growth = clamp(slope * medium.change.x, -2.0, 2.0);
  medium.steepness = min(abs(slope) * (abs(medium.change.x) + abs(medium.change.y)), 4.0);
  vec2 moments = momentsOfEmission(medium.depth, medium.growth);
  medium.centre = moments.x;
  medium.variance = moments.y;
  float seen = clamp(mean + medium.change.x * (medium.centre - 0.5), segment.low, segment.high);
  medium.colour = segment.material.rgb + segment.slope.rgb * (seen - segment.anchor);
  return medium;
}

// By how much the centre may be wrong. For small depths the next term of its series; the greatest error for any depth is
// 0.1, in a deep part whose extinction begins at 0.
float centreError(Medium medium) {
  return min(medium.depth * medium.growth * medium.growth * (1.0 / 240.0), 0.1);
}

// Estimated error of the colour, of the worst channel.
float colourError(Medium medium, Segment segment) {
  float slope = highest(vec4(abs(segment.slope.rgb), 0.0)), steep = medium.steepness, depth = medium.depth;
  float bent = min((depth * depth + 2.0 * depth * steep) * (1.0 / 360.0), 1.0 / 6.0) + steep * (1.0 / 180.0);
  return slope * (abs(medium.change.x) * centreError(medium) + abs(medium.change.y) * bent);
}

// The light at the front, in the middle and at the back of a part.
struct Lights {
  vec2 front, middle, back;
};

vec2 lightIn(Section section, Ray ray, Cut cut, float x) {
  vec2 light = lightAlong(section.normals, mix(section.uFrom, section.uTo, x), ray.world, section.inFocus);
  return behindCut(light, cut, mix(section.sFrom, section.sTo, x));
}

// Estimated error of the light. A parabola through three points is right to 1/30 of its bend where the light's slope has
// no jump; piecesOfLight() sees to the jumps.
float lightError(Medium medium, Lights lights) {
  vec2 turn = abs(lights.back - lights.front), bend = abs(lights.front - 2.0 * lights.middle + lights.back);
  float uneven = medium.steepness + min(medium.depth, 4.0) * abs(medium.growth);
  return (bend.x + bend.y) * (1.0 / 30.0 + uneven * (1.0 / 90.0)) +
         (turn.x + turn.y + bend.x + bend.y) * centreError(medium);
}

vec4 pieceOf(Medium medium, Segment segment, Lights lights) {
  float x = medium.centre, square = medium.variance + x * x;
  vec2 light = lights.front * (1.0 - 3.0 * x + 2.0 * square) + lights.middle * (4.0 * (x - square)) +
               lights.back * (2.0 * square - x);
  vec3 together = segment.slope.rgb * (medium.change.x * (lights.back.x - lights.front.x) * medium.variance);
  return vec4(max(medium.colour * light.x + together + light.y, 0.0), 1.0)
         * (medium.depth * relativeOpacity(medium.depth));
}

// `transmittance`: in front of the part; `share`: its share of the ray's length.
vec4 integratePart(Section section, Ray ray, Cut cut, Part part, float transmittance, float share) {
  float size = (part.to - part.from) * (section.sTo - section.sFrom);
  Medium medium = mediumOf(part, size);
  Lights lights = Lights(lightIn(section, ray, cut, part.from), lightIn(section, ray, cut, 0.5 * (part.from + part.to)),
                         lightIn(section, ray, cut, part.to));
  vec4 result = pieceOf(medium, part.segment, lights);
  // A part's allowed error is its share of the bound, by its opacity or by its length: each sums to at most 1 over the ray.
  float shown = transmittance * result.a, weight = shown / (integral.maxError * max(shown, share));
  vec2 ends = mix(vec2(section.uFrom), vec2(section.uTo), vec2(part.from, part.to));
  float pieces = max(sqrt(weight * (colourError(medium, part.segment) + lightError(medium, lights))),
                     piecesOfLight(section.normals, ends.x, ends.y, section.inFocus, ray.world, weight));
  if (pieces > 1.0) {
    int count = int(ceil(min(pieces, float(MOST_PIECES)))), i = 0;
    result = vec4(0.0);
    lights.back = lights.front;
    do {
      vec2 u = vec2(i, i + 1) / float(count);
      Part piece = partBetween(part, u.x, u.y);
      lights = Lights(lights.back, lightIn(section, ray, cut, 0.5 * (piece.from + piece.to)),
                      lightIn(section, ray, cut, piece.to));
      result = over(result, pieceOf(mediumOf(piece, size / float(count)), part.segment, lights));
    } while (++i < count);
  }
  return result;
}

bool shows(Part part) { return part.segment.material.a > 0.0 || part.segment.slope.a != 0.0; }

// The part of a section from `from` to the next node, or to the section's end. `index`: its segment; that of the part
// behind it afterwards.
Part nextPart(Section section, float from, inout int index) {
  Part part;
  part.segment = segmentAt(index);
  part.from = from;
  part.to = 1.0;
  part.entries = bernsteinBetween(section.entries, from, 1.0);
  float low = part.segment.low, high = part.segment.high;
  if (leavesHull(part.entries, low, high)) {
    // The front lies on the node where the part before ended: from there inwards.
    float hair = min(0.01, 0.25 * (high - low));
    part.entries.x = clamp(part.entries.x, low + hair, high - hair);
    float end = firstExit(part.entries, low, high);
    if (end < 1.0) {
      index += bernstein(part.entries, end) < 0.5 * low + 0.5 * high ? -1 : 1;
      part.entries = bernsteinBetween(part.entries, 0.0, end);
      part.to = mix(from, 1.0, end);
    }
  }
  return part;
}

// `transmittance`: in front of the section; `share`: its share of the ray's length.
vec4 integrateSection(Section section, Ray ray, Cut cut, float transmittance, float share) {
  if (!isByValue(section)) {
    Segment segment =
        constantSegment(vec4(section.material.rgb / max(section.material.a, 1e-30), section.material.a));
    return integratePart(section, ray, cut, Part(0.0, 1.0, vec4(0.0), segment), transmittance, share);
  }
  vec4 result = vec4(0.0);
  int index = segmentNear(functionOf(section), section.entries.x), left = MOST_PARTS;
  float from = 0.0;
  do {
    Part part = nextPart(section, from, index);
    if (--left == 0) part.to = 1.0;
    if (shows(part))
      result = over(result, integratePart(section, ray, cut, part, transmittance * (1.0 - result.a),
                                          share * (part.to - part.from)));
    from = part.to;
  } while (from < 1.0);
  return result;
}

Section wholeOf(CellPath path, CellNormals normals) {
  Section section;
  section.uFrom = 0.0;
  section.uTo = 1.0;
  section.sFrom = path.sFrom;
  section.sTo = path.sTo;
  section.entries = path.entries;
  section.inFocus = false;
  section.material = vec4(0.0);
#if FOCUS_FUNCTIONS || FAINT_LABELS
  section.function = int(path.functions);
#endif
  section.normals = normals;
  return section;
}

// A cell that holds both focus and context, or context of several functions, section by section.
vec4 integrateSections(CellPath path, Ray ray, Cut cut, float transmittance, float share) {
  Section section = wholeOf(path, normalsAlong(path.cell, path.a, path.b));
  addFocusNormals(section.normals, path.cell, path.a, path.b);
  vec4 result = vec4(0.0);
  // A cubic crosses the two ends of a range at most six times; colours and functions change at three places.
  int left = 10;
  section.uTo = 0.0;
  do {
    section.uFrom = section.uTo;
    bool held = sideOf(bernstein(path.focusAlong, section.uFrom)) == 0.0;
    section.inFocus = held && !ONLY_FOCUS;
    section.uTo = nextChange(path.focusAlong, section.uFrom);
    if (section.inFocus) section.uTo = min(section.uTo, nextColour(path.a, path.b, section.uFrom));
    else section.uTo = min(section.uTo, nextFunction(path.a, path.b, section.uFrom));
    section.sFrom = mix(path.sFrom, path.sTo, section.uFrom);
    section.sTo = mix(path.sFrom, path.sTo, section.uTo);
    section.entries = bernsteinBetween(path.entries, section.uFrom, section.uTo);
    float middle = 0.5 * (section.uFrom + section.uTo);
    vec3 at = vec3(path.cell) + mix(path.a, path.b, middle);
    section.material = focusMaterial(at);
    findFunction(section, path, at);
    if (held || !ONLY_FOCUS)
      result = over(result, integrateSection(section, ray, cut, transmittance * (1.0 - result.a),
                                             share * (section.uTo - section.uFrom)));
  } while (section.uTo < 1.0 && --left > 0);
  return result;
}

// The state of a ray's walk.
struct Walk {
  Ray ray;
  Cut cut;
  ivec3 upwards;
  ivec3 cell;        // that the ray is in from s on
  float s;
  int axis;          // of the face by which it came in
  int entered;       // 1: `corners` holds the voxels of that face
  float corners[8];  // of the cell before, turned
  CellPath path;     // looked into last
  CellNormals normals;  // along it
  float integrated;  // of it, 0 to 1
  int segment;       // that holds what is behind that
  int parts;         // of the path so far
  int stage;
  int after;         // the stage after an integration: LEAP, or ENDED where the ray leaves the volume
  vec4 result;       // colour and opacity so far, premultiplied
};

Walk walkFrom(Ray ray, Cut cut, bool visible) {
  Walk walk;
  walk.ray = ray;
  walk.cut = cut;
  walk.upwards = upwardsOf(ray);
  walk.cell = cellAt(ray, cut.start);
  walk.s = cut.start;
  walk.axis = 0;
  walk.entered = 0;
  walk.corners = float[8](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  walk.integrated = 0.0;
  walk.segment = walk.parts = 0;
  walk.stage = visible ? LEAP : ENDED;
  walk.after = ENDED;
  walk.result = vec4(0.0);
  return walk;
}

// Crosses a block.
void moveOn(inout Walk walk, Block block) {
  Face face = faceBehind(block, walk.ray, walk.upwards, walk.s);
  walk.s = face.s;
  walk.cell = cellBehind(face, walk.upwards);
  walk.axis = face.across.y + 2 * face.across.z;
  walk.stage = face.s < walk.ray.sOut && isInVolume(walk.cell) ? LEAP : ENDED;
}

void leap(inout Walk walk) {
  int empty = distanceToVisible(walk.cell);
  walk.stage = LOOK;
  if (empty > 0) {
    moveOn(walk, blockAt(walk.cell, walk.upwards, empty));
    walk.entered = 0;
  }
}

// After a leap the walk takes the voxels of the face by which it left the empty block first, then the cell behind it.
void look(inout Walk walk) {
  bool entered = walk.entered != 0;
  stepInto(walk.ray, entered ? walk.cell : cellBefore(walk.ray, walk.cell, walk.axis), walk.axis, walk.corners);
  walk.entered = 1;
  walk.stage = LEAP;
  if (entered) {
    ivec3 cell = walk.cell;
    float s = walk.s;
    moveOn(walk, blockAt(cell, walk.upwards, 0));
    walk.after = walk.stage;
    int needed = lookInto(walk.ray, cell, s, min(walk.s, walk.ray.sOut), walk.corners, walk.path);
    if (needed != LEAP) walk.stage = needed;
  }
}

// Adds what the walk has integrated. `whole`: whether that was the rest of the cell.
void add(inout Walk walk, vec4 colour, bool whole) {
  walk.result = over(walk.result, colour);
  if (whole) walk.stage = walk.after;
  if (1.0 - walk.result.a < integral.leastTransmittance) walk.stage = ENDED;
}

float shareOf(Walk walk) { return (walk.path.sTo - walk.path.sFrom) / max(walk.ray.sOut - walk.cut.start, 1e-30); }

// Integrates the next part of a cell that holds none of the focus and one function of the context. A ray with more parts than its neighbours does not hold
// them up: it stays in the stage CONTEXT until they are there again.
void integrateContext(inout Walk walk) {
  CellPath path = walk.path;
  if (walk.integrated == 0.0) {
    walk.normals = normalsAlong(path.cell, path.a, path.b);
    walk.segment = segmentNear(int(path.functions), path.entries.x);
    walk.parts = 0;
  }
  Section section = wholeOf(path, walk.normals);
  Part part = nextPart(section, walk.integrated, walk.segment);
  if (!shows(part) && part.to < 1.0) part = nextPart(section, part.to, walk.segment);
  if (++walk.parts == MOST_PARTS) part.to = 1.0;
  vec4 colour = vec4(0.0);
  if (shows(part))
    colour = integratePart(section, walk.ray, walk.cut, part, 1.0 - walk.result.a, shareOf(walk) * (part.to - part.from));
  bool whole = part.to == 1.0;
  walk.integrated = whole ? 0.0 : part.to;
  add(walk, colour, whole);
}

// Integrates a cell some of which may be in the focus, or that has several functions.
void integrateSections(inout Walk walk) {
  CellPath path = walk.path;
  vec2 range = focusRange();
  if (walk.cut.onFocus != 0u && path.sFrom == walk.cut.start)
    path.focusAlong.x = clamp(path.focusAlong.x, range.x, range.y);
  add(walk, integrateSections(path, walk.ray, walk.cut, 1.0 - walk.result.a, shareOf(walk)), true);
}

void follow(inout Walk walk) {
  if (walk.stage == ENDED) return;
  do {
    do {
      do {
        do {
          if (walk.stage == LEAP) leap(walk);
        } while (IN_STEP && walk.stage == LEAP);
        if (walk.stage == LOOK) look(walk);
      } while (IN_STEP && walk.stage == LEAP);
      if (walk.stage == CONTEXT) integrateContext(walk);
    } while (IN_STEP && (walk.stage == LEAP || walk.stage == CONTEXT));
    if ((HAS_FOCUS || HAS_FAINT) && walk.stage == SECTIONS) integrateSections(walk);
  } while (walk.stage != ENDED);
}

void integrate(inout Walk walks[RAYS]) {
  for (int i = 0; i < RAYS; ++i) follow(walks[i]);
}

vec4 colourOf(Walk walk) {
  bool terminated = walk.after == LEAP && 1.0 - walk.result.a < integral.leastTransmittance;
  return terminated ? compensateTermination(walk.result) : walk.result;
}
