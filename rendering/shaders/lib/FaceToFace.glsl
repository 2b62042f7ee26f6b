// The volume rendering integral from face to face of the cells along a ray. From one face to the next the values are
// taken to run evenly, and over them the transfer function is integrated, not sampled. A ray meets a face between four
// voxels, where a point inside a cell lies between eight, and bends of the trilinear field are met at every one.
//
// Rays are followed RAYS at a time, side by side: from voxel to colour every step waits for the one before, and while
// one ray waits there is the other's work to do.

// Where a ray is: the value there, and its entry in the tables.
struct FacePoint {
  float s;  // mm along the ray
  float stored;
  Bound bound;
#if SHADING
  vec3 gated;  // normal
#endif
};

// A face that a ray meets.
struct Face {
  ivec3 cell;    // that it leaves there
  bvec3 across;  // the face's axis
  float s;
};

// What a ray goes through at once: one cell, or more of them where nothing shows.
struct Block {
  ivec3 cell, last;  // along each axis from one to the other
  bool empty;        // nothing shows
  uint slot;         // of the focus, if it is not empty; 0: none of it
};

// How far a ray has got.
struct Walk {
  Ray ray;
  Cut cut;
  ivec3 upwards;  // 1 on axes along which it runs to higher indices
  Block block;    // ahead
  FacePoint front, back;
  vec4 result;
  bool more;
};

// Where a ray comes into a cell. From cell to cell the sum of the indices changes by one, whatever is skipped.
void classify(inout FacePoint point, ivec3 cell) {
  float phase = LEAST_SPAN * float((cell.x + cell.y + cell.z) & 1);
  point.bound = boundNear(point.stored * transferMap.x + transferMap.y, phase);
}

void classify(inout FacePoint point) { point.bound = boundAt(point.stored * transferMap.x + transferMap.y); }

// Where the ray meets a face.
FacePoint pointOnFace(Walk walk, Face face) {
  vec3 w = clamp(cellPosition(walk.ray, face.s) - vec3(face.cell), 0.0, 1.0);
  ivec3 low = max(face.cell - 1, ivec3(0)), high = min(face.cell, volumeDims - 1);
  ivec3 met = mix(low, high, bvec3(walk.upwards));
  low = mix(low, met, face.across);
  high = mix(high, met, face.across);
  // The face's own axes are the first and the last of those that the ray does not cross.
  float along = face.across.x ? w.y : w.x, aside = face.across.z ? w.y : w.z;
  ivec3 voxels[4] = ivec3[4](low, ivec3(high.x, face.across.x ? high.y : low.y, low.z),
                             ivec3(low.x, face.across.z ? high.y : low.y, high.z), high);
  FacePoint point;
  point.s = face.s;
  vec4 texels = vec4(imageLoad(volumeTexels, voxels[0]).r, imageLoad(volumeTexels, voxels[1]).r,
                     imageLoad(volumeTexels, voxels[2]).r, imageLoad(volumeTexels, voxels[3]).r);
  vec2 edges = mix(texels.xz, texels.yw, along);
  point.stored = texelScale * mix(edges.x, edges.y, aside);
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
vec4 pieceBetween(Walk walk, FacePoint front, FacePoint back, vec4 material, bool focus) {
  float size = back.s - front.s;
  vec2 light = vec2(1.0, 0.0);
#if SHADING
  float u = centreOfEmission(material.a * size), s = front.s + u * size;
  light = lightOfGated(mix(front.gated, back.gated, u), walk.ray.world);
#if FOCUS_KIND == 1
  if (focus) {
    vec3 smoothed = focusNormal(cellPosition(walk.ray, s));
    if (dot(smoothed, smoothed) > FLAT_FOCUS) light = lightOf(normalize(smoothed), walk.ray.world);
  }
#endif
  light = behindCut(light, walk.cut, s);
#endif
  return pieceOf(material, size, light);
}

// The same of the context, over what the ray went through last. Lit, in two halves: it is the half that light comes
// from that has to be lit.
vec4 contextBetween(Walk walk) {
  FacePoint front = walk.front, back = walk.back;
#if SHADING
  FacePoint middle = between(front, back, 0.5);
  vec4 first = pieceBetween(walk, front, middle, meanMaterial(front.bound, middle.bound), false);
  vec4 second = pieceBetween(walk, middle, back, meanMaterial(middle.bound, back.bound), false);
  return first + (1.0 - first.a) * second;
#else
  return pieceOver(front.bound, back.bound, back.s - front.s);
#endif
}

#if FOCUS_KIND != 0
// The part of the way through a cell that is in the focus, from and to 0 … 1; empty where from ≥ to.
vec2 focusPart(Walk walk, Block met) {
#if FOCUS_KIND == 1
  uint corners = focusCorners(met.slot, met.cell);
  vec3 from = cellPosition(walk.ray, walk.front.s), to = cellPosition(walk.ray, walk.back.s);
  vec2 ends = vec2(focusIndicator(corners, clamp(from - vec3(met.cell), 0.0, 1.0)),
                   focusIndicator(corners, clamp(to - vec3(met.cell), 0.0, 1.0)));
  vec2 range = vec2(0.5, 2.0);
#else
  if (!focusCellKept(met.slot, met.cell)) return vec2(1.0, 0.0);
  vec2 ends = vec2(walk.front.stored, walk.back.stored), range = vec2(focusLow, focusHigh);
#endif
  if (walk.cut.onFocus && walk.front.s == walk.cut.start) ends.x = clamp(ends.x, range.x, range.y);
  if (ends.x == ends.y) return ends.x >= range.x && ends.x <= range.y ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  vec2 at = (range - ends.x) / (ends.y - ends.x);
  return clamp(vec2(min(at.x, at.y), max(at.x, at.y)), 0.0, 1.0);
}

// A cell some of which is in the focus: what lies before, in and behind it, each seen as one piece.
vec4 throughFocus(Walk walk, vec2 part) {
  FacePoint front = walk.front, back = walk.back;
  FacePoint enters = between(front, back, part.x), leaves = between(front, back, max(part.x, part.y));
  vec4 inside = focusMaterial(cellPosition(walk.ray, 0.5 * (enters.s + leaves.s)));
  vec4 result = pieceBetween(walk, front, enters, meanMaterial(front.bound, enters.bound), false);
  result += (1.0 - result.a) * pieceBetween(walk, enters, leaves, inside, true);
  vec4 behind = pieceBetween(walk, leaves, back, meanMaterial(leaves.bound, back.bound), false);
  return result + (1.0 - result.a) * behind;
}
#endif

Block blockFrom(ivec3 cell, ivec3 upwards) {
  ivec3 brick = cell >> BRICK_SHIFT;
  int empty = int(imageLoad(occupiedSkip, brick).r);
  ivec3 end = BRICK_SIDE * (brick + empty * (2 * upwards - 1) + 1 - upwards) - upwards;
  Block block;
  block.cell = cell;
  block.empty = empty > 0;
  block.last = block.empty ? end : cell;
#if FOCUS_KIND == 0
  block.slot = 0u;
#else
  block.slot = imageLoad(focusBricks, brick).r;
#endif
  return block;
}

// By which the ray leaves the block.
Face faceBehind(Walk walk) {
  Block block = walk.block;
  vec3 planes = clamp(vec3(block.last + walk.upwards), vec3(0.5), vec3(volumeDims) + 0.5);
  vec3 sides = mix((planes - walk.ray.base) * walk.ray.inverse, vec3(FAR), equal(walk.ray.inverse, vec3(0.0)));
  Face face;
  face.s = max(min(sides.x, min(sides.y, sides.z)), walk.back.s);
  face.across.x = sides.x <= sides.y && sides.x <= sides.z;
  face.across.y = !face.across.x && sides.y <= sides.z;
  face.across.z = !face.across.x && !face.across.y;
  // Rounding must not carry the other two axes out of the block.
  ivec3 there = ivec3(cellPosition(walk.ray, face.s));
  there = clamp(there, min(block.cell, block.last), max(block.cell, block.last));
  face.cell = mix(there, block.last, face.across);
  return face;
}

ivec3 cellBehind(Walk walk, Face face) { return face.cell + mix(ivec3(0), 2 * walk.upwards - 1, face.across); }

Walk walkFrom(Ray ray, float start, Cut cut, bool visible) {
  Walk walk;
  walk.ray = ray;
  walk.cut = cut;
  walk.upwards = ivec3(greaterThan(ray.direction, vec3(0.0)));
  ivec3 cell = clamp(ivec3(floor(cellPosition(ray, start))), ivec3(0), volumeDims);
  walk.block = blockFrom(cell, walk.upwards);
  walk.back = pointInside(ray, cell, start);
  classify(walk.back, cell);
  walk.front = walk.back;
  walk.result = vec4(0.0);
  walk.more = visible;
  return walk;
}

// Whether empty blocks are hopped over without a look at the values between them: it costs every step a little.
const bool HOPS = SHADING != 0;

// Through a block to the face behind it.
void advance(inout Walk walks[RAYS], out Block met[RAYS]) {
  Face faces[RAYS];
  Block ahead[RAYS];
  EACH {
    bool hops;
    do {
      faces[i] = faceBehind(walks[i]);
      ahead[i] = blockFrom(cellBehind(walks[i], faces[i]), walks[i].upwards);
      hops = HOPS && walks[i].block.empty && ahead[i].empty;
      if (hops) {
        walks[i].block = ahead[i];
        walks[i].back.s = faces[i].s;
      }
    } while (hops);
  }
  EACH walks[i].front = walks[i].back;
  EACH walks[i].back = pointOnFace(walks[i], faces[i]);
  EACH classify(walks[i].back, ahead[i].cell);
  EACH {
    met[i] = walks[i].block;
    walks[i].block = ahead[i];
  }
}

// A piece is not waited for: what was left of the light in front of it tells whether the ray goes on behind it.
void add(inout Walk walk, Block met, vec4 piece) {
  float through = 1.0 - walk.result.a;
  if (walk.more && !met.empty) walk.result += through * piece;
  bool inside = all(lessThan(uvec3(walk.block.cell), uvec3(volumeDims + 1)));
  walk.more = walk.more && inside && through >= leastTransmittance;
}

bool anyMore(Walk walks[RAYS]) {
  bool more = false;
  EACH more = more || walks[i].more;
  return more;
}

#if FOCUS_KIND != 0
bool anyAtFocus(Walk walks[RAYS]) {
  bool found = false;
  EACH found = found || (walks[i].more && walks[i].block.slot != 0u);
  return found;
}
#endif

// Loops here are left at their ends: where rays that run side by side share their instructions, a loop left earlier
// runs to its end all the same, for nobody.
void integrate(Ray rays[RAYS], float starts[RAYS], Cut cuts[RAYS], bool visible[RAYS], out vec4 results[RAYS]) {
  Walk walks[RAYS];
  EACH walks[i] = walkFrom(rays[i], starts[i], cuts[i], visible[i]);
  Block met[RAYS];
  do {
    do {
#if FOCUS_KIND != 0
      // A cell where the focus may be costs more than one without. To leave here keeps what llvmpipe (Mesa 22.3) would
      // lose: what one ray has worked out in a loop that it leaves at the end, and others do not.
      if (anyAtFocus(walks)) break;
#endif
      advance(walks, met);
      EACH add(walks[i], met[i], contextBetween(walks[i]));
    } while (anyMore(walks));
#if FOCUS_KIND != 0
    advance(walks, met);
    EACH {
      vec4 piece = contextBetween(walks[i]);
      if (met[i].slot != 0u) piece = throughFocus(walks[i], focusPart(walks[i], met[i]));
      add(walks[i], met[i], piece);
    }
#endif
  } while (anyMore(walks));
  EACH results[i] = walks[i].result;
}
