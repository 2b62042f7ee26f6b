// The volume rendering integral of a spline, voxel cell by voxel cell, within a bound on its error
// (lib/integral/CellPath.glsl).
//
// The coefficients around a cell of the voxels' grid are read once for all of the ray's path through it. The values along
// the path are two cubics (lib/volume/Spline.glsl), and each half of it is integrated as a path through a cell of trilinear
// values is. Normals are read only where something shows.
//
// The walk's stages are those of lib/integral/CellByCell.glsl. Looking into a cell costs as much as integrating it: rays
// that run in step finish their cells before the next look.
#include <volume>
#include "lib/VoxelCell.glsl"
#include "lib/integral/CellPath.glsl"
#include "lib/integral/SplineNormals.glsl"

// The state of a ray's walk.
struct Walk {
  Ray ray;
  Cut cut;
  ivec3 upwards;
  ivec3 cell;        // that the ray is in from s on, of the finer grid
  float s;
  CellPath path;     // through the voxel cell looked into last, but for its values; `cell` is the middle one in it
  SplineAlong values;  // along it
  NormalsAlong normals;
  int next;          // half of the path that is integrated next
  float integrated;  // of it, 0 to 1
  int segment;       // that holds what is behind that
  int parts;         // of the half so far
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
  walk.next = HALVES;
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
  walk.stage = face.s < walk.ray.sOut && isInVolume(walk.cell) ? LEAP : ENDED;
}

void leap(inout Walk walk) {
  int empty = invisibleAround(walk.cell);
  walk.stage = LOOK;
  if (empty != 0) moveOn(walk, blockAt(walk.cell, walk.upwards, empty));
}

// A half of the path looked into last.
CellPath halfOf(Walk walk, int each) {
  CellPath path = walk.path;
  float from = float(each) / float(HALVES), to = float(each + 1) / float(HALVES);
  path.sFrom = mix(walk.path.sFrom, walk.path.sTo, from);
  path.sTo = mix(walk.path.sFrom, walk.path.sTo, to);
  path.a = mix(walk.path.a, walk.path.b, from);
  path.b = mix(walk.path.a, walk.path.b, to);
  setValues(path, halfOf(walk.values, each));
  return path;
}

// The first half from one on in which the context may show; HALVES where it does in none.
int nextShown(Walk walk, int each) {
  int found = HALVES;
  for (int i = HALVES - 1; i >= 0; --i)
    if (i >= each && mayShow(halfOf(walk, i))) found = i;
  return found;
}

void look(inout Walk walk) {
  ivec3 cell = middleOf(walk.cell);
  walk.path.cell = cell;
  walk.path.labels = labelsIn(cell);
  walk.path.sFrom = walk.s;
  moveOn(walk, voxelBlockAt(walk.cell, walk.upwards));
  walk.path.sTo = min(walk.s, walk.ray.sOut);
  walk.path.a = withinMiddle(cellPosition(walk.ray, walk.path.sFrom) - vec3(cell));
  walk.path.b = withinMiddle(cellPosition(walk.ray, walk.path.sTo) - vec3(cell));
  walk.after = walk.stage;
  walk.values = splineAlong(cell, walk.path.a, walk.path.b);
  walk.next = nextShown(walk, 0);
  walk.integrated = 0.0;
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  bool meets = false;
  for (int i = 0; i < HALVES; ++i) {
    CellPath path = halfOf(walk, i);
    setFocus(path, held, halfOf(walk.values, i));
    meets = meets || mayMeetFocus(path);
  }
  int shown = walk.path.labels != 0u ? SECTIONS : CONTEXT;
  int needed = !isShown(false) || walk.next == HALVES ? walk.after : shown;
  walk.stage = mayHoldFocus(held) && meets ? SECTIONS : needed;
}

// Adds what the walk has integrated. `whole`: whether that was the rest of the cell.
void add(inout Walk walk, vec4 colour, bool whole) {
  walk.result = over(walk.result, colour);
  if (whole) walk.stage = walk.after;
  if (1.0 - walk.result.a < integral.leastTransmittance) walk.stage = ENDED;
}

float shareOf(Walk walk, CellPath path) { return (path.sTo - path.sFrom) / max(walk.ray.sOut - walk.cut.start, 1e-30); }

// Integrates the next part of a half that holds none of the focus and no translucent label.
void integrateContext(inout Walk walk) {
  CellPath path = halfOf(walk, walk.next);
  if (walk.integrated == 0.0) {
    walk.segment = segmentOf(0, path.entries);
    walk.parts = 0;
  }
  Section section = wholeOf(path, halfOf(walk.normals, walk.next));
  Part part = nextPart(section, walk.integrated, walk.segment);
  if (!shows(part) && part.to < 1.0) part = nextPart(section, part.to, walk.segment);
  if (++walk.parts == MOST_PARTS) part.to = 1.0;
  vec4 colour = vec4(0.0);
  if (shows(part))
    colour = integratePart(section, walk.ray, walk.cut, part, 1.0 - walk.result.a,
                           shareOf(walk, path) * (part.to - part.from));
  bool whole = part.to == 1.0;
  walk.integrated = whole ? 0.0 : part.to;
  if (whole) walk.next = nextShown(walk, walk.next + 1);
  add(walk, colour, whole && walk.next == HALVES);
}

// Integrates a cell some of which may be in the focus, or of a translucent label.
void integrateSections(inout Walk walk) {
  vec2 range = focusRange();
  FocusCell held = focusCellAt(focusSlot(walk.path.cell), walk.path.cell);
  int each = 0;
  do {
    CellPath path = halfOf(walk, each);
    setFocus(path, held, halfOf(walk.values, each));
    if (walk.cut.onFocus != 0u && path.sFrom == walk.cut.start)
      path.focusAlong.x = ontoFocus(path.focusAlong.x, range);
    vec4 colour = integrateSections(path, halfOf(walk.normals, each), walk.ray, walk.cut, 1.0 - walk.result.a,
                                     shareOf(walk, path), walk.bodies);
    add(walk, colour, each == HALVES - 1);
  } while (++each < HALVES);
}

void follow(inout Walk walk) {
  if (walk.stage == ENDED) return;
  do {
    do {
      do {
        if (walk.stage == LEAP) leap(walk);
      } while (IN_STEP && walk.stage == LEAP);
      if (walk.stage == LOOK) look(walk);
    } while (IN_STEP && walk.stage == LEAP);
    if (walk.stage == CONTEXT || walk.stage == SECTIONS)
      walk.normals = normalsAlongSpline(walk.path.cell, walk.path.a, walk.path.b);
    do {
      if (walk.stage == CONTEXT) integrateContext(walk);
    } while (walk.stage == CONTEXT);
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
