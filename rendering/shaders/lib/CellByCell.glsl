// The volume rendering integral cell by cell. In a cell the values along a ray are a cubic, known exactly from the eight
// corners with full float weights. It is cut into as many pieces as the bound on the error asks for, and over a piece the
// transfer function is integrated, not sampled: no spike of opacity and no thin layer is stepped over.

uniform float maxError;  // of a pixel's colour

const int MOST_PIECES = 64;
const vec2 UNLIT = vec2(1.0, 0.0);

// What a ray finds between two faces of a cell. Vectors of four are Bernstein coefficients along it.
struct CellPath {
  ivec3 cell;
  vec3 a, b;         // both ends within the cell, 0 to 1
  float sFrom, sTo;  // mm along the ray
  vec4 entries;      // table entries of the values
#if FOCUS_KIND != 0
  bool focus;        // some of it may be in the focus
  vec4 focusAlong;   // in the focus from 0 to focusWidth
#endif
};

float lowest(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float highest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

#if FOCUS_KIND == 1
const float focusWidth = FAR;
#elif FOCUS_KIND == 2
float focusWidth = focusHigh - focusLow;
#endif

// The corners of the cells along a ray are kept in a frame turned so that it runs upwards along every axis: then a step
// along an axis leaves a cell by its upper face, whose corners are the next cell's lower ones.
ivec3 turned(Ray ray) { return ivec3(lessThanEqual(ray.direction, vec3(0.0))); }

void stepInto(Ray ray, ivec3 cell, int axis, inout float f[8]) {
  // Of the upper corners, 7 is one for each axis.
  int upper[4] = int[4](1 << axis, axis < 2 ? 3 : 5, axis < 1 ? 5 : 6, 7);
  float g[4];
  for (int j = 0; j < 4; ++j)
    g[j] = storedAt(cell - 1 + (cornerOf(upper[j]) ^ turned(ray)));
  bool x = axis == 0, y = axis == 1, z = axis == 2;
  f = float[8](x ? f[1] : y ? f[2] : f[4], x ? g[0] : y ? f[3] : f[5], x ? f[3] : y ? g[0] : f[6], z ? f[7] : g[1],
               x ? f[5] : y ? f[6] : g[0], x ? g[2] : y ? f[7] : g[1], x ? f[7] : g[2], g[3]);
}

// Where a ray comes from that enters a cell along `axis`.
ivec3 cellBefore(Ray ray, ivec3 cell, int axis) {
  cell[axis] -= ray.direction[axis] > 0.0 ? 1 : -1;
  return cell;
}

// `a` and `b`: ends within the cell, not turned.
vec4 bernsteinTurned(Ray ray, float f[8], vec3 a, vec3 b) {
  bvec3 downwards = bvec3(turned(ray));
  return bernsteinAlong(f, mix(a, 1.0 - a, downwards), mix(b, 1.0 - b, downwards));
}

// False where nothing shows. `f`: the cell's corners, turned.
bool lookInto(Ray ray, ivec3 cell, float s, float sNext, float f[8], out CellPath path) {
  path.cell = cell;
  path.sFrom = s;
  path.sTo = sNext;
  path.a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  path.b = clamp(cellPosition(ray, sNext) - vec3(cell), 0.0, 1.0);
  vec4 stored = bernsteinTurned(ray, f, path.a, path.b);
  path.entries = stored * transferMap.x + transferMap.y;
#if FOCUS_KIND != 0
  uint slot = focusSlot(cell);
#if FOCUS_KIND == 1
  uint corners = focusCorners(slot, cell);
  for (int i = 0; i < 8; ++i) f[i] = float((corners >> i) & 1u) - 0.5;
  path.focusAlong = bernsteinAlong(f, path.a, path.b);
  path.focus = corners != 0u && highest(path.focusAlong) >= 0.0;
#else
  path.focusAlong = stored - focusLow;
  path.focus = focusCellKept(slot, cell) && lowest(path.focusAlong) <= focusWidth && highest(path.focusAlong) >= 0.0;
#endif
  if (path.focus) return true;
#endif
  return highest(path.entries) > visibleEntries.x && lowest(path.entries) < visibleEntries.y;
}

#if FOCUS_KIND != 0
// Below, in or above the focus's range: -1, 0, 1.
float sideOf(float value) { return value < 0.0 ? -1.0 : value > focusWidth ? 1.0 : 0.0; }

// Where after u, at most at 1, the focus begins or ends.
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

#if FOCUS_KIND == 1 && FOCUS_PALETTE
// Where after u, at most at 1, the nearest voxel changes, which tells the colour: half way between voxel centres.
float nextColour(CellPath path, float u) {
  vec3 at = (0.5 - path.a) / (path.b - path.a);
  at = mix(vec3(1.0), at, greaterThan(at, vec3(u)));
  return min(min(at.x, at.y), min(at.z, 1.0));
}
#endif
#endif

vec4 over(vec4 front, vec4 back) { return front + (1.0 - front.a) * back; }

// A part of a path that is all in the focus, of one material, or all in the context.
struct Section {
  float uFrom, uTo;  // of the path
  float sFrom, sTo;  // mm along the ray
  vec4 entries;
  bool focus;
  vec4 material;     // of the focus
#if SHADING
  CellNormals normals;
#endif
};

#if FINE
// Between so many entries what is hidden tells more than rounding (float32).
const float LEAST_HIDDEN = 256.0, MOST_HIDDEN = 1e6;
const int FEWEST_PIECES = 3;
#else
const int FEWEST_PIECES = 2;
#endif

// A bound with both integrals carried on beyond the table.
struct End {
  Bound bound;
#if FINE
  float extinction;
  vec3 hidden;
#endif
};

End endAt(float entry) {
  End end;
  end.bound = boundAt(entry);
#if FINE
  float inside = clamp(end.bound.entry, 0.0, LAST_ENTRY), beyond = end.bound.entry - inside;
  vec4 constant = beyond < 0.0 ? firstMaterial : lastMaterial;
  vec3 hidden = imageLoad(transferTables, ivec2(int(inside), 2)).rgb;
  end.extinction = end.bound.integral.a + beyond * constant.a;
  end.hidden = hidden + constant.rgb * (beyond * 0.5 * (end.bound.integral.a + end.extinction));
#endif
  return end;
}

// What a stretch of values hides of itself more than if it were all of its mean material, for a length of 1: of second
// order. Where values run evenly, ∫∫ emission(x) extinction(y) over y < x, y in front.
vec3 hiddenBetween(End front, End back, vec4 material) {
#if FINE
  float span = back.bound.entry - front.bound.entry;
  float inside = clamp(back.bound.entry, 0.0, LAST_ENTRY) - clamp(front.bound.entry, 0.0, LAST_ENTRY);
  if (abs(inside) >= LEAST_HIDDEN && abs(span) <= MOST_HIDDEN)
    return (back.hidden - front.hidden) / (span * span)
           - material.rgb * (front.extinction / span + 0.5 * material.a);
#endif
  return vec3(0.0);
}

// `doubt`: how wrong its colour may be, from what it hides of itself, which is right for light that hardly fades.
vec4 pieceIn(Section section, Ray ray, Cut cut, End front, End back, float from, float to, out float doubt) {
  float size = (to - from) * (section.sTo - section.sFrom);
  vec4 material = meanMaterial(front.bound, back.bound);
  vec3 hidden = hiddenBetween(front, back, material);
#if FOCUS_KIND != 0
  if (section.focus) {
    material = section.material;
    hidden = vec3(0.0);
  }
#endif
  vec2 light = UNLIT;
#if SHADING
  float x = mix(from, to, centreOfEmission(material.a * size));
  light = behindCut(lightAlong(section.normals, mix(section.uFrom, section.uTo, x), ray.world, section.focus), cut,
                    mix(section.sFrom, section.sTo, x));
#endif
  vec4 piece = pieceOf(material, size, light);
  float seen = size * relativeOpacity(material.a * size);
  hidden *= light.x * seen * seen;
  doubt = piece.a * max(max(abs(hidden.r), abs(hidden.g)), abs(hidden.b));
  piece.rgb = max(piece.rgb - hidden, vec3(0.0));
  return piece;
}

// So many pieces, up to what is worth it.
int piecesFor(float count) { return int(ceil(min(count, float(MOST_PIECES)))); }

// `transmittance` in front of it; `share` of the ray's length is in it.
vec4 integrateSection(Section section, Ray ray, Cut cut, float transmittance, float share) {
  End first = endAt(section.entries.x), last = endAt(section.entries.w);
  float doubt;
  vec4 coarse = pieceIn(section, ray, cut, first, last, 0.0, 1.0, doubt);
  // A cell may be wrong by its share of the picture or of the ray: either sums to at most 1 over the ray.
  float shown = transmittance * coarse.a, allowed = maxError * max(shown, share);
  int countBefore = 1, count = FEWEST_PIECES;
  // Where light dies within a piece, it is the surface's place in it that is not known.
  bool surface = !section.focus && coarse.a > 0.99;
#if SHADING
  count = max(count, piecesFor(piecesOfLight(section.normals, section.focus, ray.world, shown / allowed, surface)));
#endif
  // One loop over the pieces of all rounds: rays that run side by side wait for each other at its end alone.
  vec4 fine = vec4(0.0);
  End front = first;
  float from = 0.0, doubtful = 0.0;
  int i = 0;
  do {
    float to = float(++i) / float(count);
    End back = endAt(bernstein(section.entries, to));
    vec4 piece = pieceIn(section, ray, cut, front, back, from, to, doubt);
    doubtful += (1.0 - fine.a) * doubt;
    fine = over(fine, piece);
    front = back;
    from = to;
    if (i == count) {
      // Of second order: n pieces are wrong by 1/n² of what one is; of first order where a surface is looked for.
      float ratio = float(countBefore) / float(count);
      if (!surface) ratio *= ratio;
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
  section.focus = false;
  section.material = vec4(0.0);
#if SHADING
  section.normals = normalsAlong(path.cell, path.a, path.b);
#endif
  return section;
}

#if FOCUS_KIND != 0
// A cell with both, section by section.
vec4 integrateFocusCell(CellPath path, Ray ray, Cut cut, float transmittance, float share) {
  Section section = wholeOf(path);
#if FOCUS_KIND == 1 && SHADING
  focusNormalsAlong(path.cell, path.a, path.b, section.normals);
#endif
  vec4 result = vec4(0.0);
  // A cubic crosses the two ends of a range at most six times, and colours change at three places.
  int left = 10;
  section.uTo = 0.0;
  do {
    section.uFrom = section.uTo;
    section.focus = sideOf(bernstein(path.focusAlong, section.uFrom)) == 0.0;
    section.uTo = nextChange(path.focusAlong, section.uFrom);
#if FOCUS_KIND == 1 && FOCUS_PALETTE
    if (section.focus) section.uTo = min(section.uTo, nextColour(path, section.uFrom));
#endif
    section.sFrom = mix(path.sFrom, path.sTo, section.uFrom);
    section.sTo = mix(path.sFrom, path.sTo, section.uTo);
    section.entries = bernsteinBetween(path.entries, section.uFrom, section.uTo);
    float middle = 0.5 * (section.uFrom + section.uTo);
    section.material = focusMaterial(vec3(path.cell) + mix(path.a, path.b, middle));
    result = over(result, integrateSection(section, ray, cut, transmittance * (1.0 - result.a),
                                           share * (section.uTo - section.uFrom)));
  } while (section.uTo < 1.0 && --left > 0);
  return result;
}
#endif

// Loops here are left at their ends: where rays that run side by side share their instructions, a loop left earlier
// runs to its end all the same, for nobody.
vec4 integrate(Ray ray, float start, Cut cut) {
  vec4 result = vec4(0.0);
  ivec3 cellCount = volumeDims + 1;
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, start))), ivec3(0), cellCount - 1);
  float s = start, perLength = 1.0 / max(ray.sOut - start, 1e-30);
  // A ray meets at most the sum of the three sides in cells, and as many bricks on top, behind each of which it takes
  // the face by which it enters the next cell first.
  int left = 3 * (cellCount.x + cellCount.y + cellCount.z), axis = 0;
  float corners[8] = float[8](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  bool entered = false, more = true;
  do {
    CellPath path;
    bool shows, inContext;
    // Up to the next cell with focus in it, which costs more than one without.
    do {
      // Walk to the next cell that shows something, so that rays that run side by side integrate together.
      do {
        shows = false;
        int empty;
        do {
          ivec3 brick = cell >> BRICK_SHIFT;
          empty = int(imageLoad(occupiedSkip, brick).r);
          if (empty > 0) {
            ivec3 lower = (brick - (empty - 1)) * BRICK_SIDE, upper = (brick + empty) * BRICK_SIDE;
            left = leaveBlock(ray, lower, upper, ray.sOut, cell, s, axis) ? left - 1 : 0;
            entered = false;
          }
        } while (empty > 0 && left > 0);
        // Behind a skipped block first the face by which it was left, then the one beyond.
        stepInto(ray, entered ? cell : cellBefore(ray, cell, axis), axis, corners);
        if (entered) {
          ivec3 held = cell;
          float sFrom = s;
          bool goesOn = leaveBlock(ray, held, held + 1, ray.sOut, cell, s, axis);
          shows = lookInto(ray, held, sFrom, min(s, ray.sOut), corners, path);
          if (!goesOn) left = 0;
        }
        entered = true;
      } while (!shows && --left > 0);
      inContext = shows;
#if FOCUS_KIND != 0
      inContext = shows && !path.focus;
#endif
      if (inContext)
        result = over(result, integrateSection(wholeOf(path), ray, cut, 1.0 - result.a,
                                               (path.sTo - path.sFrom) * perLength));
      more = left > 0 && 1.0 - result.a >= leastTransmittance;
    } while (inContext && more);
#if FOCUS_KIND != 0
    if (shows && path.focus) {
      if (cut.onFocus && path.sFrom == start) path.focusAlong.x = clamp(path.focusAlong.x, 0.0, focusWidth);
      result = over(result, integrateFocusCell(path, ray, cut, 1.0 - result.a, (path.sTo - path.sFrom) * perLength));
      more = left > 0 && 1.0 - result.a >= leastTransmittance;
    }
#endif
  } while (more);
  // Of what the light that is left might still have met, half is taken for there, in the colour so far.
  if (left > 0) result *= 1.0 + 0.5 * (1.0 - result.a) / max(result.a, 0.5);
  return result;
}

void integrate(Ray rays[RAYS], float starts[RAYS], Cut cuts[RAYS], bool visible[RAYS], out vec4 results[RAYS]) {
  results[0] = vec4(0.0);
  if (visible[0]) results[0] = integrate(rays[0], starts[0], cuts[0]);
}
