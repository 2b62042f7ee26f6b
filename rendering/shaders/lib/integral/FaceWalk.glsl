// A ray's walk from face to face of the cells, and pieces of it between two points.
#include <focusNormals>
#include <light>
#include <occlusion>
#include <opening>
#include "lib/PreIntegration.glsl"
#include "lib/Traversal.glsl"
#include "lib/integral/Bodies.glsl"
#include "lib/integral/CellField.glsl"
#include "lib/integral/Piece.glsl"
#include "lib/integral/RayPoint.glsl"

// The state of a ray's walk. No member is a bool: lavapipe refuses local arrays that hold one.
struct Walk {
  Ray ray;
  Cut cut;
  ivec3 upwards;
  Block block;            // ahead of the ray
  uint slot;              // of the focus, in that block
  uint labels;            // of the context, in that block's first cell
  RayPoint front, back;   // of the segment crossed last
  CellField field;        // of that segment's cell; with lib/segment/Cells.glsl
  vec4 result;            // colour and opacity so far, premultiplied
  Bodies bodies;          // with HAS_BODIES
  vec4 last;              // of the last segment that shows anything to speak of
  int left;               // 1: the ray goes on
};

// Early ray termination: what lies behind the last segment can no longer be seen.
bool goesOn(Walk walk) { return walk.left != 0; }
bool isWhole(Walk walk) { return walk.slot == 0u && walk.labels == 0u; }
// Whether the segment ahead may have parts: in the focus, or of a translucent label.
bool mayHaveParts(Walk walk) { return goesOn(walk) && !isWhole(walk); }

// `gated`: the gated normal at the position (cell frame), for where the focus has no normal of its own.
vec2 lightOfFocus(vec3 gated, vec3 position, vec3 rayDirection) {
  if (OWN_NORMALS) {
    vec3 smoothed = focusNormal(position);
    if (dot(smoothed, smoothed) > FLAT_FOCUS) return lightOf(normalize(smoothed), rayDirection);
  }
  return lightOfGated(gated, rayDirection);
}

// Premultiplied colour and opacity of one material from one point to another, lit as at the centre of its emission.
vec4 pieceBetween(Walk walk, RayPoint front, RayPoint back, vec4 material, bool ofFocus) {
  float size = back.s - front.s, u = centreOfEmission(material.a * size), s = front.s + u * size;
  vec3 gated = mix(front.gated, back.gated, u);
  vec2 light = ofFocus ? lightOfFocus(gated, cellPosition(walk.ray, s), walk.ray.world)
                       : lightOfGated(gated, walk.ray.world);
  light = behindCut(light, walk.cut, s);
  light = occluded(light, mix(front.open, back.open, u));
  return pieceOf(material, size, light);
}

// Over so many mm from one entry of lib/PreIntegration.glsl to a different one.
Segment segmentBetween(float front, float back, float size) {
  bool rises = back > front;
  float perEntry = size / abs(back - front);
  Level level = levelOf(perEntry);
  vec4 seenInFront = seenFrom(front, rises, level), seenBehind = seenFrom(back, rises, level);
  return segmentOver(front, seenInFront, back, seenBehind, perEntry, level);
}
