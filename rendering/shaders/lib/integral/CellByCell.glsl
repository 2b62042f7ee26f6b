// The volume rendering integral cell by cell, within a bound on its error (lib/integral/CellPath.glsl).
//
// In a cell the values along a ray are a cubic, known exactly from the eight corners with full float weights.
//
// A walk goes through stages, each more expensive than the one before: leap to a cell that is not empty; look into it;
// integrate it. Where neighbouring rays run in step, a ray waits until all of them need the next stage.
#include <volume>
#include "lib/integral/CellNormals.glsl"
#include "lib/integral/CellPath.glsl"

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

// Fills in what lies between s and sNext, and tells the stage that it needs: SECTIONS, CONTEXT, or LEAP where nothing shows.
// `f`: the cell's corners, turned.
int lookInto(Ray ray, ivec3 cell, float s, float sNext, float f[8], out CellPath path) {
  path.cell = cell;
  path.labels = labelsIn(cell);
  path.sFrom = s;
  path.sTo = sNext;
  path.a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  path.b = clamp(cellPosition(ray, sNext) - vec3(cell), 0.0, 1.0);
  vec4 stored = bernsteinTurned(ray, f, path.a, path.b);
  setValues(path, stored);
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  setFocus(path, held, stored);
  if (mayHoldFocus(held) && mayMeetFocus(path)) return SECTIONS;
  if (!isShown(false)) return LEAP;
  int shown = path.labels != 0u ? SECTIONS : CONTEXT;
  return mayShow(path) ? shown : LEAP;
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
  Bodies bodies;     // with HAS_BODIES
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
  walk.bodies = noBodies();
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
  int empty = invisibleAround(walk.cell);
  walk.stage = LOOK;
  if (empty != 0) {
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

// Integrates the next part of a cell that holds none of the focus and no translucent label. A ray with more parts than
// its neighbours does not hold them up: it stays in the stage CONTEXT until they are there again.
void integrateContext(inout Walk walk) {
  CellPath path = walk.path;
  if (walk.integrated == 0.0) {
    walk.normals = normalsAlong(path.cell, path.a, path.b);
    walk.segment = segmentOf(0, path.entries);
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

// Integrates a cell some of which may be in the focus, or of a translucent label.
void integrateSections(inout Walk walk) {
  CellPath path = walk.path;
  vec2 range = focusRange();
  if (walk.cut.onFocus != 0u && path.sFrom == walk.cut.start)
    path.focusAlong.x = ontoFocus(path.focusAlong.x, range);
  CellNormals normals = normalsAlong(path.cell, path.a, path.b);
  add(walk, integrateSections(path, normals, walk.ray, walk.cut, 1.0 - walk.result.a, shareOf(walk), walk.bodies), true);
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
