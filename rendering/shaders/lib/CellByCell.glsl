// The volume rendering integral cell by cell. In a cell the values along a ray are a cubic, known exactly from the eight
// corners with full float weights. It is cut into as many pieces as the bound on the error asks for, and over a piece the
// transfer function is integrated, not sampled: no spike of opacity and no thin layer is stepped over.

uniform float maxError;  // of a pixel's colour

const int MOST_PIECES = 64;
// Cells that the focus's surface runs through, or an edge between its colours: between two points so near, the surface
// is found by one secant.
const int FOCUS_PIECES = 8;
// How many times smaller than allowed an error has to seem where only two coarse answers are compared, which may agree
// by chance: of the integral, and of the light over it.
const float INTEGRAL_SAFETY = 8.0, LIGHT_SAFETY = 8.0;
const vec2 UNLIT = vec2(1.0, 0.0);

// What a ray finds between two faces of a cell.
struct CellPath {
  ivec3 cell;
  float sFrom, sTo;  // mm along the ray
  vec4 entries;      // table entries of the values, Bernstein coefficients
#if FOCUS_KIND != 0
  bool focus;        // some of it may be in the focus
  bool focusAll;     // all of it is
  vec4 focusAlong;   // in the focus where not negative, Bernstein coefficients
#if FOCUS_KIND == 2
  float halfRange;   // the focus is where |focusAlong| ≤ halfRange
#endif
#endif
};

float lowest(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float highest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// False where nothing shows.
bool lookInto(Ray ray, ivec3 cell, float s, float sNext, out CellPath path) {
  path.cell = cell;
  path.sFrom = s;
  path.sTo = sNext;
  vec3 a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(ray, sNext) - vec3(cell), 0.0, 1.0);
  float f[8];
  cellCorners(cell, f);
  vec4 stored = bernsteinAlong(f, a, b);
  path.entries = stored * transferMap.x + transferMap.y;
#if FOCUS_KIND != 0
  uint slot = focusSlot(cell);
#if FOCUS_KIND == 1
  uint corners = focusCorners(slot, cell);
  path.focus = corners != 0u;
  if (path.focus) {
    for (int i = 0; i < 8; ++i) f[i] = float((corners >> i) & 1u) - 0.5;
    path.focusAlong = bernsteinAlong(f, a, b);
    path.focus = highest(path.focusAlong) >= 0.0;
    path.focusAll = lowest(path.focusAlong) >= 0.0;
  }
#else
  path.halfRange = 0.5 * (focusHigh - focusLow);
  path.focusAlong = stored - 0.5 * (focusLow + focusHigh);
  path.focus = focusCellKept(slot, cell) && lowest(path.focusAlong) <= path.halfRange
               && highest(path.focusAlong) >= -path.halfRange;
  path.focusAll = path.focus && highest(abs(path.focusAlong)) <= path.halfRange;
#endif
  if (path.focus) return true;
#endif
  return meanMaterial(boundAt(lowest(path.entries)), boundAt(highest(path.entries))).a > 0.0;
}

#if FOCUS_KIND != 0
// In the focus where not negative.
float focusAt(CellPath path, float u) {
  float field = bernstein(path.focusAlong, u);
#if FOCUS_KIND == 2
  field = path.halfRange - abs(field);
#endif
  return field;
}
#endif

vec4 over(vec4 front, vec4 back) { return front + (1.0 - front.a) * back; }

// Light along a cell's path: evenly from end to end, or found piece by piece.
struct CellLight {
  vec2 from, to;
  bool pieceByPiece;
};

// A cell's colour, and the same unlit and without the focus, which its error is estimated by.
struct CellIntegral {
  vec4 lit, plain;
};

CellIntegral integrateInPieces(int count, CellPath path, Ray ray, Cut cut, CellLight light) {
  CellIntegral result = CellIntegral(vec4(0.0), vec4(0.0));
  vec3 from = cellPosition(ray, path.sFrom), to = cellPosition(ray, path.sTo);
  float pieceLength = (path.sTo - path.sFrom) / float(count);
  Bound front = boundAt(path.entries.x);
#if FOCUS_KIND != 0
  float focusFront = path.focus ? focusAt(path, 0.0) : -1.0;
#endif
  for (int i = 0; i < count; ++i) {
    float u = (float(i) + 1.0) / float(count), middle = (float(i) + 0.5) / float(count);
    float s = mix(path.sFrom, path.sTo, middle);
    vec3 at = mix(from, to, middle);
    Bound back = boundAt(bernstein(path.entries, u));
    vec2 contextLight = mix(light.from, light.to, middle);
#if SHADING
    if (light.pieceByPiece) contextLight = lightAt(at, ray.world, false);
#endif
    contextLight = behindCut(contextLight, cut, s);
    vec4 context = meanMaterial(front, back);
    vec4 piece = pieceOf(context, pieceLength, contextLight);
    result.plain = over(result.plain, pieceOf(context, pieceLength, UNLIT));
#if FOCUS_KIND != 0
    float focusBack = path.focus ? focusAt(path, u) : -1.0;
    bool enters = focusFront < 0.0 && focusBack >= 0.0, leaves = focusFront >= 0.0 && focusBack < 0.0;
    if (enters || focusFront >= 0.0) {
      vec2 focusLight = contextLight;
#if SHADING && FOCUS_KIND == 1
      focusLight = behindCut(lightAt(at, ray.world, true), cut, s);
#endif
      vec4 focus = focusMaterial(at);
      piece = pieceOf(focus, pieceLength, focusLight);
      if (enters || leaves) {
        // Its surface is in this piece: a part on either side.
        float part = focusFront / (focusFront - focusBack);
        Bound surface = boundAt(bernstein(path.entries, u + (part - 1.0) / float(count)));
        vec4 focusPart = pieceOf(focus, (leaves ? part : 1.0 - part) * pieceLength, focusLight);
        vec4 contextPart = leaves ? pieceOf(meanMaterial(surface, back), (1.0 - part) * pieceLength, contextLight)
                                  : pieceOf(meanMaterial(front, surface), part * pieceLength, contextLight);
        piece = leaves ? over(focusPart, contextPart) : over(contextPart, focusPart);
      }
    }
    focusFront = focusBack;
#endif
    result.lit = over(result.lit, piece);
    front = back;
  }
  return result;
}

// `transmittance` in front of the cell; `share` of the ray's length is in it.
vec4 integrateCell(CellPath path, Ray ray, Cut cut, float transmittance, float share) {
  // In one piece and in three: with the ends, two points inside tell all of a cubic.
  float whole = path.sTo - path.sFrom, third = whole / 3.0;
  Bound p0 = boundAt(path.entries.x), p1 = boundAt(bernstein(path.entries, 1.0 / 3.0));
  Bound p2 = boundAt(bernstein(path.entries, 2.0 / 3.0)), p3 = boundAt(path.entries.w);
  vec4 once = pieceOf(meanMaterial(p0, p3), whole, UNLIT);
  vec4 before = over(over(pieceOf(meanMaterial(p0, p1), third, UNLIT), pieceOf(meanMaterial(p1, p2), third, UNLIT)),
                     pieceOf(meanMaterial(p2, p3), third, UNLIT));
  // A cell may be wrong by its share of the picture or of the ray: either sums to at most 1 over the ray.
  float shown = transmittance * before.a;
  float allowed = maxError * max(shown, share);
  // Of second order: n pieces are wrong by 1/n² of what one is.
  float wrong = transmittance * highest(abs(before - once));
  int count = 3;
  if (INTEGRAL_SAFETY * wrong > allowed) count = max(6, int(ceil(sqrt(wrong / allowed))));
  // Where values turn around inside the cell, what they reach there may show at none of these points.
  float low = min(p0.entry, p3.entry) - LEAST_SPAN, high = max(p0.entry, p3.entry) + LEAST_SPAN;
  if (lowest(path.entries) < low || highest(path.entries) > high) count = max(count, 4);

  CellLight light = CellLight(UNLIT, UNLIT, false);
  bool focus = false;
#if FOCUS_KIND != 0
  focus = path.focus;
  if (focus) count = path.focusAll && FOCUS_PALETTE == 0 ? 3 : max(count, FOCUS_PIECES);
#endif
#if SHADING
  vec3 from = cellPosition(ray, path.sFrom), to = cellPosition(ray, path.sTo);
  light = CellLight(lightAt(from, ray.world, false), lightAt(to, ray.world, false), focus);
  if (!focus && shown > allowed) {
    vec2 bend = abs(lightAt(0.5 * (from + to), ray.world, false) - 0.5 * (light.from + light.to));
    float wrongLight = LIGHT_SAFETY * shown * max(bend.x, bend.y);
    light.pieceByPiece = wrongLight > allowed;
    if (light.pieceByPiece) count = max(count, int(ceil(sqrt(wrongLight / allowed))));
  }
#endif

  int countBefore = 3;
  for (;;) {
    count = min(count, MOST_PIECES);
    CellIntegral now = integrateInPieces(count, path, ray, cut, light);
    if (focus || count == countBefore || count == MOST_PIECES) return now.lit;
    float ratio = float(countBefore * countBefore) / float(count * count);
    if (transmittance * highest(abs(now.plain - before)) * ratio <= allowed * (1.0 - ratio)) return now.lit;
    before = now.plain;
    countBefore = count;
    count *= 2;
  }
}

vec4 integrate(Ray ray, float start, Cut cut) {
  vec4 result = vec4(0.0);
  ivec3 cellCount = volumeDims + 1;
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, start))), ivec3(0), cellCount - 1);
  float s = start, perLength = 1.0 / max(ray.sOut - start, 1e-30);
  // A ray meets at most the sum of the three sides in cells, and as many bricks on top.
  int left = 2 * (cellCount.x + cellCount.y + cellCount.z);
  while (left > 0) {
    // Walk to the next cell that shows something, so that rays that run side by side integrate together.
    bool shows = false;
    CellPath path;
    for (; !shows && left > 0; --left) {
      ivec3 brick = cell >> 3;
      int empty = int(texelFetch(occupiedSkip, brick, 0).r);
      ivec3 lower = empty > 0 ? (brick - (empty - 1)) * 8 : cell;
      ivec3 upper = empty > 0 ? (brick + empty) * 8 : cell + 1;
      int axis;
      float sNext = max(blockExit(ray, lower, upper, axis), s);
      if (empty == 0) shows = lookInto(ray, cell, s, min(sNext, ray.sOut), path);
      // Rounding must not carry the other two axes out of the block that was just left.
      ivec3 next = clamp(ivec3(floor(cellPosition(ray, sNext))), lower, upper - 1);
      next[axis] = ray.direction[axis] > 0.0 ? upper[axis] : lower[axis] - 1;
      if (sNext >= ray.sOut || any(lessThan(next, ivec3(0))) || any(greaterThanEqual(next, cellCount))) left = 0;
      cell = next;
      s = sNext;
    }
    if (!shows) break;
    result = over(result, integrateCell(path, ray, cut, 1.0 - result.a, (path.sTo - path.sFrom) * perLength));
    if (1.0 - result.a < leastTransmittance) break;
  }
  return result;
}
