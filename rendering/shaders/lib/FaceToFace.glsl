// The volume rendering integral from face to face of the cells along a ray. From one face to the next the values are
// taken to run evenly, and over them the transfer function is integrated, not sampled. A ray meets a face between four
// voxels, where a point inside a cell lies between eight, and bends of the trilinear field are met at every one.

// Where a ray is: the value there, and its entry in the tables.
struct FacePoint {
  float s;  // mm along the ray
  float stored;
  Bound bound;
#if SHADING
  vec3 gated;  // normal
#endif
};

void classify(inout FacePoint point) { point.bound = boundAt(point.stored * transferMap.x + transferMap.y); }

// Where the ray meets the face of `cell` across one axis, the one with the higher index on axes where `upper`.
FacePoint pointOnFace(Ray ray, ivec3 cell, float s, bvec3 across, bvec3 upper) {
  vec3 w = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  ivec3 low = max(cell - 1, ivec3(0)), high = min(cell, volumeDims - 1), face = mix(low, high, upper);
  low = mix(low, face, across);
  high = mix(high, face, across);
  // The face's own axes are the first and the last of those that the ray does not cross.
  float along = across.x ? w.y : w.x, aside = across.z ? w.y : w.z;
  ivec3 voxels[4] = ivec3[4](low, ivec3(high.x, across.x ? high.y : low.y, low.z),
                             ivec3(low.x, across.z ? high.y : low.y, high.z), high);
  FacePoint point;
  point.s = s;
  vec4 corners = storedFrom(vec4(imageLoad(volumeTexels, voxels[0]).r, imageLoad(volumeTexels, voxels[1]).r,
                                 imageLoad(volumeTexels, voxels[2]).r, imageLoad(volumeTexels, voxels[3]).r));
  vec2 edges = mix(corners.xz, corners.yw, along);
  point.stored = mix(edges.x, edges.y, aside);
  classify(point);
#if SHADING
  point.gated = mix(mix(gatedAt(voxels[0]), gatedAt(voxels[1]), along),
                    mix(gatedAt(voxels[2]), gatedAt(voxels[3]), along), aside);
#endif
  return point;
}

// Anywhere in a cell.
FacePoint pointInside(Ray ray, ivec3 cell, float s) {
  FacePoint point;
  point.s = s;
  point.stored = storedExact(cellPosition(ray, s));
  classify(point);
#if SHADING
  vec3 w = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  point.gated = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    vec3 weights = mix(1.0 - w, w, bvec3(cornerOf(i)));
    point.gated += weights.x * weights.y * weights.z * gatedAt(cell - 1 + cornerOf(i));
  }
#endif
  return point;
}

// Part of the way from one to another.
FacePoint between(FacePoint front, FacePoint back, float u) {
  FacePoint point;
  point.s = mix(front.s, back.s, u);
  point.stored = mix(front.stored, back.stored, u);
  classify(point);
#if SHADING
  point.gated = mix(front.gated, back.gated, u);
#endif
  return point;
}

// Premultiplied colour and opacity of one material from one point to another, lit as where it is seen on average.
vec4 pieceBetween(Ray ray, Cut cut, FacePoint front, FacePoint back, vec4 material, bool focus) {
  float size = back.s - front.s;
  vec2 light = vec2(1.0, 0.0);
#if SHADING
  float u = centreOfEmission(material.a * size), s = front.s + u * size;
  light = lightOfGated(mix(front.gated, back.gated, u), ray.world);
#if FOCUS_KIND == 1
  if (focus) {
    vec3 smoothed = focusNormal(cellPosition(ray, s));
    if (dot(smoothed, smoothed) > FLAT_FOCUS) light = lightOf(normalize(smoothed), ray.world);
  }
#endif
  light = behindCut(light, cut, s);
#endif
  return pieceOf(material, size, light);
}

// The same of the context. Lit, in two halves: it is the half that light comes from that has to be lit.
vec4 contextBetween(Ray ray, Cut cut, FacePoint front, FacePoint back) {
#if SHADING
  FacePoint middle = between(front, back, 0.5);
  vec4 first = pieceBetween(ray, cut, front, middle, meanMaterial(front.bound, middle.bound), false);
  vec4 second = pieceBetween(ray, cut, middle, back, meanMaterial(middle.bound, back.bound), false);
  return first + (1.0 - first.a) * second;
#else
  return pieceBetween(ray, cut, front, back, meanMaterial(front.bound, back.bound), false);
#endif
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

// A cell some of which is in the focus: what lies before, in and behind it, each seen as one piece.
vec4 throughFocus(Ray ray, Cut cut, FacePoint front, FacePoint back, vec2 part) {
  FacePoint enters = between(front, back, part.x), leaves = between(front, back, max(part.x, part.y));
  vec4 inside = focusMaterial(cellPosition(ray, 0.5 * (enters.s + leaves.s)));
  vec4 result = pieceBetween(ray, cut, front, enters, meanMaterial(front.bound, enters.bound), false);
  result += (1.0 - result.a) * pieceBetween(ray, cut, enters, leaves, inside, true);
  vec4 behind = pieceBetween(ray, cut, leaves, back, meanMaterial(leaves.bound, back.bound), false);
  return result + (1.0 - result.a) * behind;
}
#endif

// Loops here are left at their ends: where rays that run side by side share their instructions, a loop left earlier
// runs to its end all the same, for nobody.
vec4 integrate(Ray ray, float start, Cut cut) {
  vec4 result = vec4(0.0);
  ivec3 cellCount = volumeDims + 1;
  bvec3 up = greaterThan(ray.direction, vec3(0.0)), parallel = equal(ray.inverse, vec3(0.0));
  ivec3 upwards = ivec3(up), stride = 2 * upwards - 1;
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, start))), ivec3(0), cellCount - 1);
  FacePoint back = pointInside(ray, cell, start), front = back;
  // A ray meets at most the sum of the three sides in cells, and as many bricks on top, behind each of which it takes
  // the face by which it enters the next cell first.
  int left = 3 * (cellCount.x + cellCount.y + cellCount.z);
  bool entered = true, more = true;
  bvec3 across = bvec3(false);
  do {
    ivec3 met;
    uint slot = 0u;
    bool inContext;
    // Up to the next cell where the focus may be, which costs more than one without.
    do {
      // To the next brick that shows something.
      ivec3 brick;
      int empty;
      do {
        brick = cell >> BRICK_SHIFT;
        empty = int(imageLoad(occupiedSkip, brick).r);
        if (empty > 0) {
          ivec3 lower = (brick - (empty - 1)) * BRICK_SIDE, upper = (brick + empty) * BRICK_SIDE;
          int axis;
          left = leaveBlock(ray, lower, upper, ray.sOut, cell, back.s, axis) ? left - 1 : 0;
          across = equal(ivec3(0, 1, 2), ivec3(axis));
          entered = false;
        }
      } while (empty > 0 && left > 0);
      // Behind a skipped block first the face by which it was left, then on to the next one.
      vec3 planes = clamp(vec3(cell + upwards), vec3(0.5), vec3(volumeDims) + 0.5);
      vec3 sides = mix((planes - ray.base) * ray.inverse, vec3(FAR), parallel);
      float s = back.s;
      if (entered) {
        s = max(min(sides.x, min(sides.y, sides.z)), s);
        across = bvec3(sides.x <= sides.y && sides.x <= sides.z, sides.y < sides.x && sides.y <= sides.z,
                       sides.z < sides.x && sides.z < sides.y);
      }
      front = back;
      back = pointOnFace(ray, cell, s, across, entered ? up : not(up));
      met = cell;
      inContext = entered && left > 0;
#if FOCUS_KIND != 0
      slot = inContext ? imageLoad(focusBricks, brick).r : 0u;
      inContext = inContext && slot == 0u;
#endif
      if (entered) cell += mix(ivec3(0), stride, across);
      entered = true;
      if (any(greaterThanEqual(uvec3(cell), uvec3(cellCount)))) left = 0;
      if (inContext)
        result += (1.0 - result.a) * contextBetween(ray, cut, front, back);
      more = --left > 0 && 1.0 - result.a >= leastTransmittance;
    } while (slot == 0u && more);
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
