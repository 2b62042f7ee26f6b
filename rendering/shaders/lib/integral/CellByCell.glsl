// The volume rendering integral cell by cell, within a bound on its error.
//
// In a cell the values along a ray are a cubic, known exactly from the eight corners with full float weights. The cubic is
// cut into as many pieces as the bound asks for, and over a piece the transfer function is integrated, not sampled
// (lib/integral/Piece.glsl): no spike of opacity and no thin layer is stepped over. The error of n pieces falls as 1/n²,
// so the difference between two numbers of pieces tells how many are enough (Richardson extrapolation), and extrapolates
// the result.
//
// A walk goes through stages, each more expensive than the one before: leap to a cell that is not empty; look into it;
// integrate it. Where neighbouring rays run in step, a ray waits until all of them need the next stage.
#include <focus>
#include <light>
#include <opening>
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/Traversal.glsl"
#include "lib/Volume.glsl"
#include "lib/integral/Piece.glsl"
#include "lib/integral/Settings.glsl"

const int MOST_PIECES = 64;

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

const int LEAP = 0, LOOK = 1, CONTEXT = 2, FOCUS = 3, ENDED = 4;  // stages

// Fills in what lies between s and sNext, and tells the stage that it needs: CONTEXT, FOCUS, or LEAP where nothing shows.
// `f`: the cell's corners, turned.
int lookInto(Ray ray, ivec3 cell, float s, float sNext, float f[8], out CellPath path) {
  path.cell = cell;
  path.sFrom = s;
  path.sTo = sNext;
  path.a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  path.b = clamp(cellPosition(ray, sNext) - vec3(cell), 0.0, 1.0);
  vec4 stored = bernsteinTurned(ray, f, path.a, path.b);
  path.entries = stored * transfer.map.x + transfer.map.y;
#if FOCUS_FUNCTIONS
  path.stored = stored;
#endif
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  path.focusAlong = focusAlong(held, path.a, path.b, stored);
  vec2 range = focusRange();
  if (mayHoldFocus(held) && lowest(path.focusAlong) <= range.y && highest(path.focusAlong) >= range.x) return FOCUS;
  if (ONLY_FOCUS) return LEAP;
  vec2 visible = transfer.visibleEntries;
  return highest(path.entries) > visible.x && lowest(path.entries) < visible.y ? CONTEXT : LEAP;
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

// A part of a path that is all in the focus, of one material or function, or all in the context.
struct Section {
  float uFrom, uTo;  // of the path
  float sFrom, sTo;  // mm along the ray
  vec4 entries;      // of the context's table, or that of the focus's function
  bool inFocus;
  vec4 material;     // of the focus
#if FOCUS_FUNCTIONS
  bool byValue;      // of the focus: by its function
  Table table;       // of that
#endif
  CellNormals normals;
};

#if FOCUS_FUNCTIONS
bool isByValue(Section section) { return !section.inFocus || section.byValue; }
Table tableOf(Section section) { return section.table; }

// Chooses the function of a section of the focus.
void findFunction(inout Section section, CellPath path, vec3 at) {
  vec4 function = focusTable(at);
  section.byValue = section.inFocus && function.x > 0.0;
  section.table = contextTable();
  if (section.byValue) {
    section.table = tableFrom(int(function.x));
    section.entries = bernsteinBetween(path.stored * function.y + function.z, section.uFrom, section.uTo);
  }
}
#else
bool isByValue(Section section) { return !section.inFocus; }
Table tableOf(Section section) { return contextTable(); }
void findFunction(inout Section section, CellPath path, vec3 at) {}
#endif

// Over fewer or more entries than these the attenuation inside a piece is lost in rounding (float32).
const float LEAST_HIDDEN = 256.0, MOST_HIDDEN = 1e6;
const int FEWEST_PIECES = 3;

// A bound with both integrals continued beyond the table's ends, and the number of the transfer function's nodes up to
// it.
struct End {
  Bound bound;
  float extinction;
  vec3 hidden;
  float nodes;
};

End endAt(Table table, float entry) {
  End end;
  end.bound = boundAt(table, entry);
  float inside = clamp(end.bound.entry, 0.0, LAST_ENTRY), beyond = end.bound.entry - inside;
  vec4 constant = beyond < 0.0 ? table.first : table.last;
  vec4 hidden = texelOf(transferTables, ivec2(int(inside), table.row + 2));
  end.extinction = end.bound.integral.a + beyond * constant.a;
  end.hidden = hidden.rgb + constant.rgb * (beyond * 0.5 * (end.bound.integral.a + end.extinction));
  end.nodes = hidden.a;
  return end;
}

// Attenuation inside a piece, to second order, for a length of 1: ∫∫ emission(x) extinction(y) dy dx over y in front of x,
// less the same for the piece's mean material. Values are taken to change evenly along the piece.
vec3 hiddenBetween(End front, End back, vec4 material) {
  float span = back.bound.entry - front.bound.entry;
  float inside = clamp(back.bound.entry, 0.0, LAST_ENTRY) - clamp(front.bound.entry, 0.0, LAST_ENTRY);
  if (abs(inside) >= LEAST_HIDDEN && abs(span) <= MOST_HIDDEN)
    return (back.hidden - front.hidden) / (span * span)
           - material.rgb * (front.extinction / span + 0.5 * material.a);
  return vec3(0.0);
}

// `doubt`: estimated error of its colour, from the attenuation inside it, which is exact only for small opacities.
vec4 pieceIn(Section section, Ray ray, Cut cut, End front, End back, float from, float to, out float doubt) {
  float size = (to - from) * (section.sTo - section.sFrom);
  vec4 material = meanMaterial(tableOf(section), front.bound, back.bound);
  vec3 hidden = hiddenBetween(front, back, material);
  if (!isByValue(section)) {
    material = section.material;
    hidden = vec3(0.0);
  }
  float x = mix(from, to, centreOfEmission(material.a * size));
  vec2 light = lightAlong(section.normals, mix(section.uFrom, section.uTo, x), ray.world, section.inFocus);
  light = behindCut(light, cut, mix(section.sFrom, section.sTo, x));
  vec4 piece = pieceOf(material, size, light);
  float seen = size * relativeOpacity(material.a * size);
  hidden *= light.x * seen * seen;
  doubt = piece.a * max(max(abs(hidden.r), abs(hidden.g)), abs(hidden.b));
  piece.rgb = max(piece.rgb - hidden, vec3(0.0));
  return piece;
}

// Rounded up, MOST_PIECES at most.
int piecesFor(float count) { return int(ceil(min(count, float(MOST_PIECES)))); }

// `transmittance`: in front of the section; `share`: its share of the ray's length.
vec4 integrateSection(Section section, Ray ray, Cut cut, float transmittance, float share) {
  Table table = tableOf(section);
  End first = endAt(table, section.entries.x), last = endAt(table, section.entries.w);
  float doubt;
  vec4 coarse = pieceIn(section, ray, cut, first, last, 0.0, 1.0, doubt);
  // A section's allowed error is its share of the bound, by its opacity or by its length: each sums to at most 1 over the
  // ray.
  float shown = transmittance * coarse.a, allowed = integral.maxError * max(shown, share);
  int countBefore = 1, count = FEWEST_PIECES;
  // Where a piece is opaque, the position of the visible surface inside it is uncertain.
  bool surface = isByValue(section) && coarse.a > 0.99;
  // Where light of several colours is absorbed inside the section, one piece says little about its error, and few may
  // agree with it by chance: there are pieces enough to tell the nodes of the transfer function apart, and the error of
  // one piece is taken to fall no faster than 1/n.
  float nodes = abs(last.nodes - first.nodes);
  bool mixed = isByValue(section) && nodes >= 3.0 && coarse.a > 0.5;
  if (mixed) count = max(count, piecesFor(nodes - 0.5 * log(max(1.0 - coarse.a, 1e-6))));
  count = max(count, piecesFor(piecesOfLight(section.normals, section.inFocus, ray.world, shown / allowed, surface)));
  // One loop over the pieces of all refinements, so that rays that run in step wait for each other only once.
  vec4 fine = vec4(0.0);
  End front = first;
  float from = 0.0, doubtful = 0.0;
  int i = 0;
  do {
    float to = float(++i) / float(count);
    End back = endAt(table, bernstein(section.entries, to));
    vec4 piece = pieceIn(section, ray, cut, front, back, from, to, doubt);
    doubtful += (1.0 - fine.a) * doubt;
    fine = over(fine, piece);
    front = back;
    from = to;
    if (i == count) {
      // Richardson extrapolation: the error of n pieces falls as 1/n², at an opaque surface as 1/n.
      float ratio = float(countBefore) / float(count);
      if (!surface && !(mixed && countBefore == 1)) ratio *= ratio;
      vec4 error = (fine - coarse) * (ratio / (1.0 - ratio));
      float wrong = transmittance * (highest(abs(error)) + doubtful) / allowed;
      coarse = fine;
      fine += error;
      if (wrong > 1.0 && count < MOST_PIECES) {
        countBefore = count;
        count = max(piecesFor(float(count) * (surface ? wrong : sqrt(wrong))), min(count + 2, MOST_PIECES));
        fine = vec4(0.0);
        front = first;
        from = doubtful = 0.0;
        i = 0;
      }
    }
  } while (i < count);
  return vec4(max(fine.rgb, 0.0), clamp(fine.a, 0.0, 1.0));
}

Section wholeOf(CellPath path) {
  Section section;
  section.uFrom = 0.0;
  section.uTo = 1.0;
  section.sFrom = path.sFrom;
  section.sTo = path.sTo;
  section.entries = path.entries;
  section.inFocus = false;
  section.material = vec4(0.0);
#if FOCUS_FUNCTIONS
  section.byValue = false;
  section.table = contextTable();
#endif
  section.normals = normalsAlong(path.cell, path.a, path.b);
  return section;
}

// A cell that holds both focus and context, section by section.
vec4 integrateFocusCell(CellPath path, Ray ray, Cut cut, float transmittance, float share) {
  Section section = wholeOf(path);
  addFocusNormals(section.normals, path.cell, path.a, path.b);
  vec4 result = vec4(0.0);
  // A cubic crosses the two ends of a range at most six times, and colours change at three places.
  int left = 10;
  section.uTo = 0.0;
  do {
    section.uFrom = section.uTo;
    bool held = sideOf(bernstein(path.focusAlong, section.uFrom)) == 0.0;
    section.inFocus = held && !ONLY_FOCUS;
    section.uTo = nextChange(path.focusAlong, section.uFrom);
    if (section.inFocus) section.uTo = min(section.uTo, nextColour(path.a, path.b, section.uFrom));
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

// Integrates the cell looked into. `ofFocus`: some of it may be in the focus.
void integrateCell(inout Walk walk, const bool ofFocus) {
  CellPath path = walk.path;
  float transmittance = 1.0 - walk.result.a;
  float share = (path.sTo - path.sFrom) / max(walk.ray.sOut - walk.cut.start, 1e-30);  // of the ray's length
  vec4 colour;
  if (ofFocus) {
    vec2 range = focusRange();
    if (walk.cut.onFocus != 0u && path.sFrom == walk.cut.start)
      path.focusAlong.x = clamp(path.focusAlong.x, range.x, range.y);
    colour = integrateFocusCell(path, walk.ray, walk.cut, transmittance, share);
  } else {
    colour = integrateSection(wholeOf(path), walk.ray, walk.cut, transmittance, share);
  }
  walk.result = over(walk.result, colour);
  walk.stage = 1.0 - walk.result.a >= integral.leastTransmittance ? walk.after : ENDED;
}

void follow(inout Walk walk) {
  if (walk.stage == ENDED) return;
  do {
    do {
      do {
        do leap(walk); while (IN_STEP && walk.stage == LEAP);
        if (walk.stage == LOOK) look(walk);
      } while (IN_STEP && walk.stage == LEAP);
      if (walk.stage == CONTEXT) integrateCell(walk, false);
    } while (IN_STEP && walk.stage == LEAP);
    if (HAS_FOCUS && walk.stage == FOCUS) integrateCell(walk, true);
  } while (walk.stage != ENDED);
}

void integrate(inout Walk walks[RAYS]) {
  for (int i = 0; i < RAYS; ++i) follow(walks[i]);
}

vec4 colourOf(Walk walk) {
  bool terminated = walk.after == LEAP && 1.0 - walk.result.a < integral.leastTransmittance;
  return terminated ? compensateTermination(walk.result) : walk.result;
}
