// First hit of the focus, or of the context, along a ray: cell by cell, leaping over empty bricks.

uniform usampler3D contextSkip;   // Chebyshev distance in bricks to the nearest one that is not transparent

uniform int gapCount;             // open intervals of stored values in which the context is transparent
layout(std430, binding = 1) readonly buffer Gaps { vec2 gaps[]; };

#if FOCUS_KIND != 0
// Position of the first focus point in this cell's segment [s, sNext]; NONE when there is none.
float focusInCell(Ray ray, ivec3 cell, float s, float sNext) {
  uint slot = focusSlot(cell);
  vec3 a = cellPosition(ray, s) - vec3(cell), b = cellPosition(ray, sNext) - vec3(cell);
  a = clamp(a, 0.0, 1.0);
  b = clamp(b, 0.0, 1.0);
  float f[8];
#if FOCUS_KIND == 1
  uint corners = focusCorners(slot, cell);
  if (corners == 0u) return NONE;
  for (int i = 0; i < 8; ++i) f[i] = float((corners >> i) & 1u);
  float u = firstExit(bernsteinAlong(f, a, b), -1.0, 0.5);
#else
  if (!focusCellKept(slot, cell)) return NONE;
  cellCorners(cell, f);
  vec4 along = bernsteinAlong(f, a, b);
  float u = along.x < focusLow ? firstExit(along, -FAR, focusLow)
          : along.x > focusHigh ? firstExit(along, focusHigh, FAR) : 0.0;
#endif
  return u <= 1.0 ? mix(s, sNext, u) : NONE;
}
#endif

// `focus` chooses the field; `gap` is the context's interval to leave.
float firstHit(const bool focus, Ray ray, float sBegin, float sEnd, vec2 gap) {
  if (sBegin > sEnd) return NONE;
  ivec3 cellCount = volumeDims + 1;
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, sBegin))), ivec3(0), cellCount - 1);
  float s = sBegin;
  // A ray meets at most the sum of the three sides in cells, and as many bricks on top.
  int most = 2 * (cellCount.x + cellCount.y + cellCount.z);
  for (int visited = 0; visited < most; ++visited) {
    ivec3 brick = cell >> 3;
#if FOCUS_KIND != 0
    int empty = int(focus ? texelFetch(focusSkip, brick, 0).r : texelFetch(contextSkip, brick, 0).r);
#else
    int empty = int(texelFetch(contextSkip, brick, 0).r);
#endif
    ivec3 lower = empty > 0 ? (brick - (empty - 1)) * 8 : cell;
    ivec3 upper = empty > 0 ? (brick + empty) * 8 : cell + 1;
    int axis;
    float sNext = max(blockExit(ray, lower, upper, axis), s);
    if (empty == 0) {
      float sLast = min(sNext, sEnd);
#if FOCUS_KIND != 0
      if (focus) {
        float hit = focusInCell(ray, cell, s, sLast);
        if (!isNone(hit)) return hit;
      } else
#endif
      {
        float f[8];
        cellCorners(cell, f);
        vec3 a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
        vec3 b = clamp(cellPosition(ray, sLast) - vec3(cell), 0.0, 1.0);
        float u = firstExit(bernsteinAlong(f, a, b), gap.x, gap.y);
        if (u <= 1.0) return mix(s, sLast, u);
      }
    }
    if (sNext >= sEnd) return NONE;
    // Rounding must not carry the other two axes out of the block that was just left.
    ivec3 next = clamp(ivec3(floor(cellPosition(ray, sNext))), lower, upper - 1);
    next[axis] = ray.direction[axis] > 0.0 ? upper[axis] : lower[axis] - 1;
    if (any(lessThan(next, ivec3(0))) || any(greaterThanEqual(next, cellCount))) return NONE;
    cell = next;
    s = sNext;
  }
  return NONE;
}

#if FOCUS_KIND != 0
float firstFocusHit(Ray ray) { return firstHit(true, ray, ray.sIn, ray.sOut, vec2(0.0)); }
#endif

// First context point in [sIn, sEnd]. The field is continuous: a ray that starts inside one transparent gap of values
// can leave that gap only through its ends.
float firstContextHit(Ray ray, float sEnd) {
  if (ray.sIn > sEnd) return NONE;
  float value = storedExact(cellPosition(ray, ray.sIn));
  for (int i = 0; i < gapCount; ++i)
    if (value > gaps[i].x && value < gaps[i].y) return firstHit(false, ray, ray.sIn, sEnd, gaps[i]);
  return ray.sIn;
}
