// First hit of the focus, or of the context, along a ray: cell by cell, leaping over empty bricks.

uniform usampler3D contextSkip;   // Chebyshev distance in bricks to the nearest one that is not transparent

uniform int gapCount;             // open intervals of stored values in which the context is transparent
layout(std430, binding = 1) readonly buffer Gaps { vec2 gaps[]; };

#if FOCUS_KIND != 0
// The focus field along [a, b] in a cell as Bernstein coefficients, and the interval that it has to leave for the focus
// to be met; false where the cell holds none of the focus.
bool focusAlong(Ray ray, ivec3 cell, vec3 a, vec3 b, float values[8], out vec4 along, out vec2 gap) {
  uint slot = focusSlot(cell);
#if FOCUS_KIND == 1
  uint corners = focusCorners(slot, cell);
  if (corners == 0u) return false;
  float f[8];
  for (int i = 0; i < 8; ++i) f[i] = float((corners >> i) & 1u);
  along = bernsteinAlong(f, a, b);
  gap = vec2(-FAR, 0.5);
#else
  if (!focusCellKept(slot, cell)) return false;
  along = bernsteinTurned(ray, values, a, b);
  // Starting inside the range the gap is empty: left at once.
  gap = along.x < focusLow ? vec2(-FAR, focusLow) : along.x > focusHigh ? vec2(focusHigh, FAR) : vec2(FAR, -FAR);
#endif
  return true;
}
#endif

// `focus` chooses the field; `gap` is the context's interval to leave.
float firstHit(const bool focus, Ray ray, float sBegin, float sEnd, vec2 gap) {
  if (sBegin > sEnd) return NONE;
  ivec3 cellCount = volumeDims + 1;
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, sBegin))), ivec3(0), cellCount - 1);
  float s = sBegin;
  // A ray meets at most the sum of the three sides in cells, and as many bricks on top, behind each of which it takes
  // the face by which it enters the next cell first.
  int left = 3 * (cellCount.x + cellCount.y + cellCount.z), axis = 0;
  const bool needsValues = !focus || FOCUS_KIND == 2;
  float corners[8] = float[8](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  bool entered = false;
  // Loops are left at their ends: where rays that run side by side share their instructions, one left earlier runs to
  // its end all the same, for nobody.
  float hit = NONE;
  do {
    // Walk to the next cell whose hull reaches out of the gap. Solving for the crossing waits until the walk is over, so
    // that rays that run side by side solve together.
    bool candidate;
    vec4 along = vec4(0.0);
    float sFrom = s, sTo = s;
    do {
      candidate = false;
      ivec3 brick = cell >> 3;
#if FOCUS_KIND != 0
      int empty = int(focus ? texelFetch(focusSkip, brick, 0).r : texelFetch(contextSkip, brick, 0).r);
#else
      int empty = int(texelFetch(contextSkip, brick, 0).r);
#endif
      bool here = empty > 0 || entered || !needsValues;
      if (needsValues) stepInto(ray, here ? cell : cellBefore(ray, cell, axis), axis, corners);
      entered = empty == 0;
      if (here) {
        ivec3 lower = empty > 0 ? (brick - (empty - 1)) * 8 : cell;
        ivec3 upper = empty > 0 ? (brick + empty) * 8 : cell + 1;
        float sNext = max(blockExit(ray, lower, upper, axis), s);
        if (entered) {
          sFrom = s;
          sTo = min(sNext, sEnd);
          vec3 a = clamp(cellPosition(ray, sFrom) - vec3(cell), 0.0, 1.0);
          vec3 b = clamp(cellPosition(ray, sTo) - vec3(cell), 0.0, 1.0);
          candidate = true;
#if FOCUS_KIND != 0
          if (focus)
            candidate = focusAlong(ray, cell, a, b, corners, along, gap);
          else
#endif
            along = bernsteinTurned(ray, corners, a, b);
          candidate = candidate && leavesHull(along, gap.x, gap.y);
        }
        // Rounding must not carry the other two axes out of the block that was just left.
        ivec3 next = clamp(ivec3(floor(cellPosition(ray, sNext))), lower, upper - 1);
        next[axis] = ray.direction[axis] > 0.0 ? upper[axis] : lower[axis] - 1;
        if (sNext >= sEnd || any(lessThan(next, ivec3(0))) || any(greaterThanEqual(next, cellCount))) left = 0;
        cell = next;
        s = sNext;
      }
    } while (!candidate && --left > 0);
    float u = firstExit(along, gap.x, gap.y);
    if (candidate && u <= 1.0) hit = mix(sFrom, sTo, u);
  } while (left > 0 && isNone(hit));
  return hit;
}

#if FOCUS_KIND != 0
float firstFocusHit(Ray ray) { return firstHit(true, ray, ray.sIn, ray.sOut, vec2(0.0)); }
#endif

// First context point in [sIn, sEnd]. The field is continuous: a ray that starts inside one transparent gap of values
// can leave that gap only through its ends.
float firstContextHit(Ray ray, float sEnd) {
  if (ray.sIn > sEnd) return NONE;
  float value = storedExact(cellPosition(ray, ray.sIn));
  vec2 around = vec2(FAR, -FAR);
  for (int i = 0; i < gapCount; ++i)
    if (value > gaps[i].x && value < gaps[i].y) around = gaps[i];
  return around.x < around.y ? firstHit(false, ray, ray.sIn, sEnd, around) : ray.sIn;
}
