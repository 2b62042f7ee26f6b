// The volume rendering integral cell by cell. In a cell the values along a ray are a cubic, known exactly from the eight
// corners with full float weights. It is cut into as many pieces as the bound on the error asks for, and over a piece the
// transfer function is integrated, not sampled: no spike of opacity and no thin layer is stepped over.

uniform float maxError;  // of a pixel's colour

const int MOST_PIECES = 64;
// Cells that the focus's surface runs through, or an edge between its colours: between two points so near, the surface
// is found by one secant.
const int FOCUS_PIECES = 8;
// At most so many for the light on the focus, whose normals turn within a cell where the focus is a voxel thin.
const int MOST_LIGHT_PIECES = 32;
// How many times smaller than allowed an error has to seem where only two coarse answers are compared, which may agree
// by chance: of the integral, and of the light over it.
const float INTEGRAL_SAFETY = 8.0, LIGHT_SAFETY = 8.0;
const vec2 UNLIT = vec2(1.0, 0.0);

// What a ray finds between two faces of a cell.
struct CellPath {
  float sFrom, sTo;  // mm along the ray
  vec4 entries;      // table entries of the values, Bernstein coefficients
#if FOCUS_KIND != 0
  bool focus;        // some of it may be in the focus
  bool focusAll;     // all of it is
  vec4 focusAlong;   // in the focus where not negative (labels), Bernstein coefficients
#if FOCUS_KIND == 2
  float halfRange;   // the focus is where |focusAlong| ≤ halfRange
#endif
#endif
};

float lowest(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float highest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// False where nothing shows.
bool lookInto(Ray ray, ivec3 cell, float s, float sNext, out CellPath path) {
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
// The part of a piece that is in the focus, 0 to 1 from end to end, where the field runs evenly from `front` to `back`;
// x ≥ y where none of it is.
vec2 insideFocus(CellPath path, float front, float back) {
#if FOCUS_KIND == 2
  float low = -path.halfRange, high = path.halfRange;
#else
  float low = 0.0, high = FAR;
#endif
  if (front == back) return front >= low && front <= high ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  vec2 ends = (vec2(low, high) - front) / (back - front);
  return vec2(max(min(ends.x, ends.y), 0.0), min(max(ends.x, ends.y), 1.0));
}
#endif

vec4 over(vec4 front, vec4 back) { return front + (1.0 - front.a) * back; }

// Where in a piece of one material what is seen of it comes from on average, 0 to 1 from its front: ∫ x exp(-depth·x) dx
// over ∫ exp(-depth·x) dx. Light that changes evenly along a piece is there what it is on average.
float centreOfEmission(float depth) {
  return depth < 0.1 ? 0.5 - depth / 12.0 : 1.0 / depth - 1.0 / (exp(depth) - 1.0);
}

// Light along a cell's path: evenly from end to end, or found piece by piece.
struct CellLight {
  vec2 from, to;
  bool pieceByPiece;
};

// A cell's colour, and the same unlit and without the focus, which its error is estimated by.
struct CellIntegral {
  vec4 lit, plain;
};

// The context between two places u of a path.
vec4 contextPiece(CellPath path, Ray ray, Cut cut, CellLight light, Bound front, Bound back, float uFront, float uBack) {
  if (uFront >= uBack) return vec4(0.0);
  float size = (uBack - uFront) * (path.sTo - path.sFrom);
  vec4 material = meanMaterial(front, back);
  float u = mix(uFront, uBack, centreOfEmission(material.a * size)), s = mix(path.sFrom, path.sTo, u);
  vec2 here = mix(light.from, light.to, u);
#if SHADING
  if (light.pieceByPiece) here = lightAt(cellPosition(ray, s), ray.world, false);
#endif
  return pieceOf(material, size, behindCut(here, cut, s));
}

#if FOCUS_KIND != 0
vec4 focusPiece(CellPath path, Ray ray, Cut cut, CellLight light, float uFront, float uBack) {
  float size = (uBack - uFront) * (path.sTo - path.sFrom);
  float u = mix(uFront, uBack, centreOfEmission(focusProperties.a * size)), s = mix(path.sFrom, path.sTo, u);
  vec2 here = mix(light.from, light.to, u);
#if SHADING
  here = lightAt(cellPosition(ray, s), ray.world, true);
#endif
  here = behindCut(here, cut, s);
  vec3 from = cellPosition(ray, mix(path.sFrom, path.sTo, uFront));
#if FOCUS_KIND == 1 && FOCUS_PALETTE
  vec3 to = cellPosition(ray, mix(path.sFrom, path.sTo, uBack));
  vec4 edges = colourEdges(from, to), result = vec4(0.0);
  float begin = 0.0;
  for (int i = 0; i < 4; ++i) {
    if (edges[i] <= begin) continue;
    vec4 material = focusMaterial(mix(from, to, 0.5 * (begin + edges[i])));
    result = over(result, pieceOf(material, (edges[i] - begin) * size, here));
    begin = edges[i];
  }
  return result;
#else
  return pieceOf(focusMaterial(from), size, here);
#endif
}
#endif

CellIntegral integrateInPieces(int count, CellPath path, Ray ray, Cut cut, CellLight light) {
  CellIntegral result = CellIntegral(vec4(0.0), vec4(0.0));
  Bound front = boundAt(path.entries.x);
  float pieceLength = (path.sTo - path.sFrom) / float(count), uFront = 0.0;
  for (int i = 1; i <= count; ++i) {
    float uBack = float(i) / float(count);
    Bound back = boundAt(bernstein(path.entries, uBack));
    result.plain = over(result.plain, pieceOf(meanMaterial(front, back), pieceLength, UNLIT));
    vec2 inside = vec2(1.0, 0.0);
#if FOCUS_KIND != 0
    if (path.focus) inside = insideFocus(path, bernstein(path.focusAlong, uFront), bernstein(path.focusAlong, uBack));
    if (inside.x < inside.y) {
      vec2 u = mix(vec2(uFront), vec2(uBack), inside);
      Bound entry = boundAt(bernstein(path.entries, u.x)), exit = boundAt(bernstein(path.entries, u.y));
      result.lit = over(result.lit, contextPiece(path, ray, cut, light, front, entry, uFront, u.x));
      result.lit = over(result.lit, focusPiece(path, ray, cut, light, u.x, u.y));
      result.lit = over(result.lit, contextPiece(path, ray, cut, light, exit, back, u.y, uBack));
    } else
#endif
    {
      result.lit = over(result.lit, contextPiece(path, ray, cut, light, front, back, uFront, uBack));
    }
    front = back;
    uFront = uBack;
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
#if FOCUS_KIND != 0
  if (focus) {
    // Its own light, of labels by the smoothed indicator.
    float seen = transmittance * (1.0 - exp(-focusProperties.a * whole));
    vec2 bend = abs(lightAt(0.5 * (from + to), ray.world, true)
                    - 0.5 * (lightAt(from, ray.world, true) + lightAt(to, ray.world, true)));
    float wrongLight = LIGHT_SAFETY * seen * max(bend.x, bend.y) / (maxError * max(seen, share));
    count = max(count, min(int(ceil(sqrt(wrongLight))), MOST_LIGHT_PIECES));
  }
#endif
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
