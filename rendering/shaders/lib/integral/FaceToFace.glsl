// The volume rendering integral from face to face of the cells along a ray.
//
// Front-to-back compositing (Levoy 1988): C ← C + (1 - A) c, A ← A + (1 - A) a, with the colour c and opacity a of one
// segment. A segment runs from the face by which the ray enters a cell to the face by which it leaves. Over it values are
// taken to change evenly, and the transfer function is integrated over them, not sampled (lib/integral/Piece.glsl). A
// point on a face lies between four voxels, where a point inside a cell lies between eight; and the ray meets the bends
// of the trilinear field, which are at the faces, at every one. The error is of second order in the cells' size.
#include <clip>
#include <focus>
#include <translucent>
#include <light>
#include <opening>
#include <schedule>
#include <segment>
#include "lib/Traversal.glsl"
#include "lib/integral/FaceWalk.glsl"
#include "lib/integral/FocusParts.glsl"
#include "lib/integral/Settings.glsl"

Walk walkFrom(Ray ray, Cut cut, bool visible) {
  Walk walk;
  walk.ray = ray;
  walk.cut = cut;
  walk.upwards = upwardsOf(ray);
  ivec3 cell = cellAt(ray, cut.start);
  walk.block = blockAt(cell, walk.upwards, invisibleAround(cell));
  walk.slot = focusSlot(cell);
  walk.labels = labelsIn(cell);
  walk.back = pointInside(ray, cell, cut.start);
  classify(walk.back, cell);
  walk.front = walk.back;
  walk.result = vec4(0.0);
  walk.last = vec4(0.0);
  walk.bodies = noBodies();
  walk.left = visible ? 1 : 0;
  return walk;
}

// Whether a ray leaps from one empty block to the next without a look at the values between them. Where rays run in step,
// unlit ones do not: the test costs every step a little, and some ray among them mostly has something to integrate.
const bool LEAPS = LIT || !IN_STEP;

// The face behind the block ahead, and the block behind that face.
void lookAhead(Walk walk, out Face face, out Block behind) {
  face = faceBehind(walk.block, walk.ray, walk.upwards, walk.back.s);
  ivec3 cell = cellBehind(face, walk.upwards);
  behind = blockAt(cell, walk.upwards, invisibleAround(cell));
}

// Looks ahead after leaps over empty blocks. Results pass through an `if`; lib/schedule/Llvmpipe.glsl says why.
void leapAhead(inout Walk walk, out Face face, out Block behind) {
  bool leaps = true;
  do {
    if (leaps) {
      lookAhead(walk, face, behind);
      leaps = walk.block.empty != 0 && (LEAPS_TO_VISIBLE || behind.empty != 0) && isInVolume(behind.cell);
      if (leaps) {
        walk.block = behind;
        walk.back.s = face.s;
        if (LEAPS_TO_VISIBLE) walk.slot = focusSlot(behind.cell);
        if (LEAPS_TO_VISIBLE) walk.labels = labelsIn(behind.cell);
      }
    }
  } while (leaps);
}

void composite(inout Walk walk, Block crossed, vec4 piece) {
  if (goesOn(walk) && crossed.empty == 0) {
    walk.result += (1.0 - walk.result.a) * piece;
    if (piece.a > 1e-6) walk.last = piece;
  }
  bool more = goesOn(walk) && isInVolume(walk.block.cell) && 1.0 - walk.result.a >= integral.leastTransmittance;
  if (CLIPS) more = more && walk.back.s < walk.ray.sOut;
  walk.left = more ? 1 : 0;
}

// Every ray comes to the block that its next step crosses.
void comeToNext(inout Walk walks[RAYS], out Face faces[RAYS], out Block behind[RAYS]) {
  for (int i = 0; i < RAYS; ++i) {
    if (LEAPS)
      leapAhead(walks[i], faces[i], behind[i]);
    else
      lookAhead(walks[i], faces[i], behind[i]);
  }
}

// Every ray takes a step, through the block ahead of it. `parts`: false where no segment ahead may have parts.
//
// The rays take each part of the step together, so that one has instructions to run while the other waits for memory.
void takeStep(inout Walk walks[RAYS], Face faces[RAYS], Block behind[RAYS], const bool parts) {
  Block crossed[RAYS];
  uint slots[RAYS], isOne[RAYS];
  for (int i = 0; i < RAYS; ++i) crossBlock(walks[i], faces[i]);
  for (int i = 0; i < RAYS; ++i) classify(walks[i].back, behind[i].cell);
  for (int i = 0; i < RAYS; ++i) {
    crossed[i] = walks[i].block;
    slots[i] = walks[i].slot;
    isOne[i] = isWhole(walks[i]) ? 1u : 0u;
    walks[i].block = behind[i];
    walks[i].slot = focusSlot(behind[i].cell);
    walks[i].labels = labelsIn(behind[i].cell);
  }
  for (int i = 0; i < RAYS; ++i) {
    vec4 piece;
    if (parts && isOne[i] == 0u)
      piece = focusPiece(walks[i], crossed[i].cell, focusPart(walks[i], slots[i], crossed[i].cell));
    else
      piece = contextPiece(walks[i], crossed[i].cell);
    composite(walks[i], crossed[i], piece);
  }
}

bool anyGoesOn(Walk walks[RAYS]) {
  bool any = false;
  for (int i = 0; i < RAYS; ++i) any = any || goesOn(walks[i]);
  return any;
}

bool anyHasParts(Walk walks[RAYS]) {
  bool any = false;
  for (int i = 0; i < RAYS; ++i) any = any || mayHaveParts(walks[i]);
  return any;
}

void integrate(inout Walk walks[RAYS]) {
  const bool parts = HAS_FOCUS || HAS_FAINT;
  Face faces[RAYS];
  Block behind[RAYS];
  do {
    comeToNext(walks, faces, behind);
    // A segment that may have parts costs more than one that has none: rays that run in step wait there for each other.
    if (IN_STEP && parts) {
      do {
        if (anyHasParts(walks)) break;
        takeStep(walks, faces, behind, false);
        comeToNext(walks, faces, behind);
      } while (anyGoesOn(walks));
    }
    takeStep(walks, faces, behind, parts);
  } while (anyGoesOn(walks));
}

// What a terminated ray has not come to is taken to look like its last segment in lit pictures, and half of it like the
// ray so far in unlit ones, whose other errors are no greater than that.
vec4 colourOf(Walk walk) {
  float transmittance = 1.0 - walk.result.a;
  if (transmittance >= integral.leastTransmittance) return walk.result;
  return LIT ? walk.result + transmittance / walk.last.a * walk.last : compensateTermination(walk.result);
}
