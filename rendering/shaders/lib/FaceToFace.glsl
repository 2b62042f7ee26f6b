// The volume rendering integral from face to face of the cells along a ray. From one face to the next the values are
// taken to run evenly, and over them the transfer function is integrated, not sampled. A ray meets a face between four
// voxels, where a point inside a cell lies between eight, and bends of the trilinear field are met at every one.

// Where a ray is: the value there, and its entry in the tables.
struct FacePoint {
  float s;  // mm along the ray
  float stored;
  Bound bound;
};

FacePoint facePoint(float s, float stored) {
  return FacePoint(s, stored, boundAt(stored * transferMap.x + transferMap.y));
}

// The stored value where the ray meets the face of `cell` across one axis, the one with the higher index on axes where
// `upper`.
float storedOnFace(Ray ray, ivec3 cell, float s, bvec3 across, bvec3 upper) {
  vec3 w = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  ivec3 low = max(cell - 1, ivec3(0)), high = min(cell, volumeDims - 1), face = mix(low, high, upper);
  low = mix(low, face, across);
  high = mix(high, face, across);
  // The face's own axes are the first and the last of those that the ray does not cross.
  ivec3 alongFirst = ivec3(high.x, across.x ? high.y : low.y, low.z);
  ivec3 alongLast = ivec3(low.x, across.z ? high.y : low.y, high.z);
  vec4 texels = vec4(imageLoad(volumeTexels, low).r, imageLoad(volumeTexels, alongFirst).r,
                     imageLoad(volumeTexels, alongLast).r, imageLoad(volumeTexels, high).r);
  vec4 corners = storedFrom(texels);
  vec2 edges = mix(corners.xz, corners.yw, across.x ? w.y : w.x);
  return mix(edges.x, edges.y, across.z ? w.y : w.z);
}

vec2 lightBetween(Ray ray, Cut cut, float sFrom, float sTo, bool focus) {
  vec2 light = vec2(1.0, 0.0);
#if SHADING
  float middle = 0.5 * (sFrom + sTo);
  light = behindCut(lightAt(cellPosition(ray, middle), ray.world, focus), cut, middle);
#endif
  return light;
}

#if FOCUS_KIND != 0
// The part of the way through a cell that is in the focus, from and to 0 … 1; empty where from ≥ to.
vec2 focusPart(Ray ray, ivec3 cell, uint slot, FacePoint front, FacePoint back, bool startsInside) {
#if FOCUS_KIND == 1
  uint corners = focusCorners(slot, cell);
  vec2 ends = vec2(focusIndicator(corners, clamp(cellPosition(ray, front.s) - vec3(cell), 0.0, 1.0)),
                   focusIndicator(corners, clamp(cellPosition(ray, back.s) - vec3(cell), 0.0, 1.0)));
  vec2 range = vec2(0.5, 2.0);
#else
  if (!focusCellKept(slot, cell)) return vec2(1.0, 0.0);
  vec2 ends = vec2(front.stored, back.stored), range = vec2(focusLow, focusHigh);
#endif
  if (startsInside) ends.x = clamp(ends.x, range.x, range.y);
  if (ends.x == ends.y) return ends.x >= range.x && ends.x <= range.y ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  vec2 at = (range - ends.x) / (ends.y - ends.x);
  return clamp(vec2(min(at.x, at.y), max(at.x, at.y)), 0.0, 1.0);
}

// A cell some of which is in the focus: what lies before, in and behind it.
vec4 throughFocus(Ray ray, Cut cut, FacePoint front, FacePoint back, vec2 part) {
  vec4 result = vec4(0.0);
  float from = 0.0;
  FacePoint here = front;
  int k = 0;
  do {
    float to = k == 0 ? part.x : k == 1 ? part.y : 1.0;
    FacePoint there = facePoint(mix(front.s, back.s, to), mix(front.stored, back.stored, to));
    if (to > from) {
      bool focus = k == 1;
      vec4 material = focus ? focusMaterial(cellPosition(ray, 0.5 * (here.s + there.s)))
                            : meanMaterial(here.bound, there.bound);
      result += (1.0 - result.a)
                * pieceOf(material, there.s - here.s, lightBetween(ray, cut, here.s, there.s, focus));
      here = there;
      from = to;
    }
  } while (++k < 3);
  return result;
}
#endif

// Loops here are left at their ends: where rays that run side by side share their instructions, a loop left earlier
// runs to its end all the same, for nobody.
vec4 integrate(Ray ray, float start, Cut cut) {
  vec4 result = vec4(0.0);
  ivec3 cellCount = volumeDims + 1;
  bvec3 up = greaterThan(ray.direction, vec3(0.0)), parallel = equal(ray.inverse, vec3(0.0));
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, start))), ivec3(0), cellCount - 1);
  FacePoint back = facePoint(start, storedExact(cellPosition(ray, start))), front = back;
  // A ray meets at most the sum of the three sides in cells, and as many bricks on top, behind each of which it takes
  // the face by which it enters the next cell first.
  int left = 3 * (cellCount.x + cellCount.y + cellCount.z);
  bool entered = true, more = true;
  bvec3 across = bvec3(false);
  do {
    bool shows, inContext;
    ivec3 met;
    uint slot = 0u;
    // Up to the next cell where the focus may be, which costs more than one without.
    do {
      // Up to the next cell that shows something, so that rays that run side by side classify together.
      do {
        ivec3 brick = cell >> BRICK_SHIFT;
        int empty = int(imageLoad(occupiedSkip, brick).r);
        bool leave = empty > 0 || entered;
        ivec3 lower = empty > 0 ? (brick - (empty - 1)) * BRICK_SIDE : cell;
        ivec3 upper = empty > 0 ? (brick + empty) * BRICK_SIDE : cell + 1;
        vec3 planes = clamp(vec3(mix(lower, upper, up)), vec3(0.5), vec3(volumeDims) + 0.5);
        vec3 sides = mix((planes - ray.base) * ray.inverse, vec3(FAR), parallel);
        float s = back.s;
        if (leave) {
          s = max(min(sides.x, min(sides.y, sides.z)), s);
          across = bvec3(sides.x <= sides.y && sides.x <= sides.z, sides.y < sides.x && sides.y <= sides.z,
                         sides.z < sides.x && sides.z < sides.y);
        }
        front = back;
        back = facePoint(s, storedOnFace(ray, cell, s, across, leave ? up : not(up)));
        shows = empty == 0 && entered && max(front.bound.entry, back.bound.entry) > visibleEntries.x
                && min(front.bound.entry, back.bound.entry) < visibleEntries.y;
#if FOCUS_KIND != 0
        slot = empty == 0 && entered ? imageLoad(focusBricks, brick).r : 0u;
        shows = shows || slot != 0u;
#endif
        entered = empty == 0;
        met = cell;
        if (leave) {
          // Rounding must not carry the other two axes out of the block that was just left.
          ivec3 next = clamp(ivec3(floor(cellPosition(ray, s))), lower, upper - 1);
          cell = mix(next, mix(lower - 1, upper, up), across);
          if (any(greaterThanEqual(uvec3(cell), uvec3(cellCount)))) left = 0;
        }
      } while (!shows && --left > 0);
      inContext = shows && slot == 0u;
      if (inContext)
        result += (1.0 - result.a) * pieceOf(meanMaterial(front.bound, back.bound), back.s - front.s,
                                             lightBetween(ray, cut, front.s, back.s, false));
      more = left > 0 && 1.0 - result.a >= leastTransmittance;
    } while (inContext && more);
#if FOCUS_KIND != 0
    if (slot != 0u) {
      vec2 part = focusPart(ray, met, slot, front, back, cut.onFocus && front.s == start);
      result += (1.0 - result.a) * throughFocus(ray, cut, front, back, part);
      more = left > 0 && 1.0 - result.a >= leastTransmittance;
    }
#endif
  } while (more);
  return result;
}
