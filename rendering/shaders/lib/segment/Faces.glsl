// A segment knows what the volume holds on the two faces that it lies between. A point on a face lies between four voxels, where
// a point inside a cell lies between eight.
//
// Cells.glsl has the same interface; `#include <segment>` names the one that the picture needs:
//   LEAPS_TO_VISIBLE  whether a ray leaps out of the last empty block, too: whether a segment needs nothing from there
//   crossBlock        takes a ray to the face behind the block ahead, or where it ends before that
//   contextPiece      what the segment crossed last shows of the context
#include <clip>
#include <light>
#include <normals>
#include <occlusion>
#include <opening>
#include <volume>
#include "lib/integral/FaceWalk.glsl"

const bool LEAPS_TO_VISIBLE = false;

// Bilinear between the face's four voxels.
RayPoint pointOnFace(Walk walk, Face face) {
  vec3 w = withinCell(walk.ray, face.cell, face.s);
  ivec3 low = max(face.cell - 1, ivec3(0)), high = min(face.cell, volume.dims - 1);
  ivec3 met = mix(low, high, bvec3(walk.upwards));
  bvec3 across = bvec3(face.across);
  low = mix(low, met, across);
  high = mix(high, met, across);
  // The face's own axes are the first and the last of those that the ray does not cross.
  float along = across.x ? w.y : w.x, aside = across.z ? w.y : w.z;
  ivec3 voxels[4] = ivec3[4](low, ivec3(high.x, across.x ? high.y : low.y, low.z),
                             ivec3(low.x, across.z ? high.y : low.y, high.z), high);
  RayPoint point;
  point.s = face.s;
  vec4 texels = vec4(texelOf(volumeTexels, voxels[0]).r, texelOf(volumeTexels, voxels[1]).r,
                     texelOf(volumeTexels, voxels[2]).r, texelOf(volumeTexels, voxels[3]).r);
  vec2 edges = mix(texels.xz, texels.yw, along);
  point.stored = TEXEL_SCALE * mix(edges.x, edges.y, aside);
  point.gated = mix(mix(gatedAt(voxels[0]), gatedAt(voxels[1]), along),
                    mix(gatedAt(voxels[2]), gatedAt(voxels[3]), along), aside);
  if (OCCLUDES) point.open = openAt(cellPosition(walk.ray, face.s));
  return point;
}

void crossBlock(inout Walk walk, Face face) {
  ivec3 cell = walk.block.cell;
  walk.front = walk.back;
  walk.back = pointOnFace(walk, face);
  if (CLIPS && face.s > walk.ray.sOut) walk.back = pointInside(walk.ray, cell, walk.ray.sOut);
}

// A lit segment is one of a refined grid, short enough for one light, taken at the centre of its emission.
vec4 contextPiece(Walk walk, ivec3 cell) {
  RayPoint front = walk.front, back = walk.back;
  Segment segment = segmentBetween(front.entry, back.entry, back.s - front.s);
  if (!LIT) return segment.piece;
  float u = centreOfEmission(segment.depth), s = mix(front.s, back.s, u);
  vec2 light = behindCut(lightOfGated(mix(front.gated, back.gated, u), walk.ray.world), walk.cut, s);
  light = occluded(light, mix(front.open, back.open, u));
  return litBy(segment.piece, light);
}
