// First hit of the focus, or of the context, along a ray: cell by cell, leaping over empty bricks.

// Chebyshev distances in bricks: to the nearest one that is not transparent, and to the nearest one with focus.
layout(r8ui) uniform readonly uimage3D contextSkip;
#if FOCUS_KIND != 0
layout(r8ui) uniform readonly uimage3D focusSkip;
#endif

uniform int gapCount;             // open intervals of stored values in which the context is transparent
layout(std430, binding = 1) readonly buffer Gaps { vec2 gaps[]; };

#if FOCUS_KIND != 0
// Corners or values of a cell that the focus reaches; false where it does not.
bool holdsFocus(ivec3 cell) {
#if FOCUS_KIND == 1
  return focusCorners(focusSlot(cell), cell) != 0u;
#else
  return focusCellKept(focusSlot(cell), cell);
#endif
}
#endif

// The field along [s, sNext] in a cell as Bernstein coefficients, of the focus or the context. For the focus also the
// interval that it has to leave for the focus to be met.
vec4 fieldAlong(const bool focus, Ray ray, ivec3 cell, float s, float sNext, inout vec2 gap) {
  vec3 a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(ray, sNext) - vec3(cell), 0.0, 1.0);
  float f[8];
#if FOCUS_KIND == 1
  if (focus) {
    uint corners = focusCorners(focusSlot(cell), cell);
    for (int i = 0; i < 8; ++i) f[i] = float((corners >> i) & 1u);
    gap = vec2(-FAR, 0.5);
    return bernsteinAlong(f, a, b);
  }
#endif
  cellCorners(cell, f);
  vec4 along = bernsteinAlong(f, a, b);
#if FOCUS_KIND == 2
  // Starting inside the range the gap is empty: left at once.
  if (focus)
    gap = along.x < focusLow ? vec2(-FAR, focusLow) : along.x > focusHigh ? vec2(focusHigh, FAR) : vec2(FAR, -FAR);
#endif
  return along;
}

// `focus` chooses the field; `gap` is the context's interval to leave. `exact`: where it leaves; else only whether it
// does, and in which cell.
float firstHit(const bool focus, const bool exact, Ray ray, float sBegin, float sEnd, vec2 gap) {
  if (sBegin > sEnd) return NONE;
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, sBegin))), ivec3(0), volumeDims);
  float s = sBegin;
  // A ray meets at most the sum of the three sides in cells, and as many bricks on top.
  int left = 2 * (volumeDims.x + volumeDims.y + volumeDims.z + 3), axis;
  // Rays that run side by side do so in step: what costs more waits, loop by loop, until all of them need it, and loops
  // are left at their ends, since one left earlier runs to its end all the same, for nobody.
  float hit = NONE;
  do {
    // To the next cell whose hull reaches out of the gap.
    bool candidate = false;
    vec4 along = vec4(0.0);
    float sFrom = s;
    do {
      // To the next cell that may hold any of it.
      bool found = false;
      do {
        ivec3 brick = cell >> BRICK_SHIFT;
#if FOCUS_KIND != 0
        int empty = int(focus ? imageLoad(focusSkip, brick).r : imageLoad(contextSkip, brick).r);
        found = empty == 0 && (!focus || holdsFocus(cell));
#else
        int empty = int(imageLoad(contextSkip, brick).r);
        found = empty == 0;
#endif
        if (!found) {
          ivec3 lower = empty > 0 ? (brick - (empty - 1)) * BRICK_SIDE : cell;
          ivec3 upper = empty > 0 ? (brick + empty) * BRICK_SIDE : cell + 1;
          left = leaveBlock(ray, lower, upper, sEnd, cell, s, axis) ? left - 1 : 0;
        }
      } while (!found && left > 0);
      if (found) {
        ivec3 held = cell;
        sFrom = s;
        left = leaveBlock(ray, held, held + 1, sEnd, cell, s, axis) ? left - 1 : 0;
        along = fieldAlong(focus, ray, held, sFrom, min(s, sEnd), gap);
        candidate = leavesHull(along, gap.x, gap.y);
      }
    } while (!candidate && left > 0);
    vec2 piece;
    float u = 2.0;
    if (candidate) u = exact ? firstExit(along, gap.x, gap.y) : leaves(along, gap.x, gap.y, piece) ? 0.0 : 2.0;
    if (u <= 1.0) hit = mix(sFrom, min(s, sEnd), u);
  } while (isNone(hit) && left > 0);
  return hit;
}

#if FOCUS_KIND != 0
float firstFocusHit(Ray ray) { return firstHit(true, true, ray, ray.sIn, ray.sOut, vec2(0.0)); }
bool meetsFocus(Ray ray) { return !isNone(firstHit(true, false, ray, ray.sIn, ray.sOut, vec2(0.0))); }
#endif

// First context point in [sIn, sEnd]. The field is continuous: a ray that starts inside one transparent gap of values
// can leave that gap only through its ends.
float firstContextHit(Ray ray, float sEnd) {
  if (ray.sIn > sEnd) return NONE;
  float value = storedExact(cellPosition(ray, ray.sIn));
  for (int i = 0; i < gapCount; ++i)
    if (value > gaps[i].x && value < gaps[i].y) return firstHit(false, true, ray, ray.sIn, sEnd, gaps[i]);
  return ray.sIn;
}
