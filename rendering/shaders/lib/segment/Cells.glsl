// All eight corners of a segment's cell are read, once, as lit pictures need them: light turns most within a cell. The segment has
// two halves, which meet in what the volume holds in its middle, and its light is taken in three places. A ray that only grazes a
// surface, outside at both faces, meets it in the middle (the interface is described in Faces.glsl).
#include <clip>
#include <light>
#include <occlusion>
#include <opening>
#include "lib/integral/CellField.glsl"
#include "lib/integral/FaceWalk.glsl"
#include "lib/integral/LightPlaces.glsl"

const bool LEAPS_TO_VISIBLE = true;

// At a position within the cell that the last segment is in.
RayPoint pointIn(Walk walk, vec3 w, float s) {
  RayPoint point;
  point.s = s;
  point.stored = storedIn(walk.field, w);
  point.gated = gatedIn(walk.field, w);
  if (OCCLUDES) point.open = openAt(cellPosition(walk.ray, s));
  return point;
}

// At part `u` of the way through a cell, from `a` to `b` within it.
vec2 lightIn(Walk walk, vec3 a, vec3 b, float u) {
  vec2 light = behindCut(lightOfGated(gatedIn(walk.field, mix(a, b, u)), walk.ray.world), walk.cut,
                         mix(walk.front.s, walk.back.s, u));
  light = occluded(light, mix(walk.front.open, walk.back.open, u));
  return light;
}

void crossBlock(inout Walk walk, Face face) {
  ivec3 cell = walk.block.cell;
  float from = walk.back.s, to = face.s;
  if (CLIPS) to = min(to, walk.ray.sOut);
  walk.field = fieldOf(cell);
  walk.front = pointIn(walk, withinCell(walk.ray, cell, from), from);
  walk.back = pointIn(walk, withinCell(walk.ray, cell, to), to);
  classify(walk.front, cell);
}

vec4 contextPiece(Walk walk, ivec3 cell) {
  RayPoint front = walk.front, back = walk.back;
  vec3 a = withinCell(walk.ray, cell, front.s), b = withinCell(walk.ray, cell, back.s);
  float middle = entryBetween(entryOf(storedIn(walk.field, 0.5 * (a + b)))), size = 0.5 * (back.s - front.s);
  Segment first = segmentBetween(front.entry, middle, size), second = segmentBetween(middle, back.entry, size);
  LightPlaces places = lightPlaces(first, second);
  vec2 minor = lightIn(walk, a, b, places.minor);
  vec2 major = mix(lightIn(walk, a, b, places.major.y), lightIn(walk, a, b, places.major.x), places.share);
  return over(litBy(first.piece, places.behind ? minor : major), litBy(second.piece, places.behind ? major : minor));
}
