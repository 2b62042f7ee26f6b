// Stage 4 where another camera cuts the opening, second step: what of a ray it removes. rendering/passes/RemovedPass.h
// defines it.
#include <removed>
#include <schedule>
#include "lib/Bilinear.glsl"
#include "lib/None.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f) uniform writeonly image2D rayStart;
layout(rg32f) uniform writeonly image2D hole;
layout(r32f) uniform writeonly image2D distances;
TEXELS_2D(rg32f, hitPoints);
uniform sampler2D faces;   // of RemovedFaces.comp
uniform float firstHole;   // mm: no hole begins before it
uniform float voxel;       // mm, its shortest side

// Shares of a voxel; see RemovedPass.h.
const float SLIVER = 0.01, SKIN = 0.5, BEHIND = 1.0;

// This picture's ray in the opening's view axes: mm from the opening's anchor point, at s = 0 and per mm.
struct Line {
  vec3 from, along;
};

vec3 pointOn(Line line, float s) { return line.from + s * line.along; }
float widening(float depth) { return 1.0 + depth * opening.perDepth; }

// Where a point shows, in pixels from the centre of the first one.
vec2 texelOfPoint(vec3 point) {
  vec2 ndc = point.xy / (opening.halfSize * widening(point.z));
  return vec2(opening.pictureSize) * (0.5 + 0.5 * vec2(ndc.x, -ndc.y)) - 0.5;
}

// The line's distance from the plane through the eye and a texel coordinate along x or along y, at s = 0 and per mm.
vec2 fromColumn(Line line, float texel) {
  float plane = opening.halfSize.x * (2.0 * (texel + 0.5) / float(opening.pictureSize.x) - 1.0);
  return vec2(line.from.x - plane * widening(line.from.z), line.along.x - plane * line.along.z * opening.perDepth);
}
vec2 fromRow(Line line, float texel) {
  float plane = opening.halfSize.y * (1.0 - 2.0 * (texel + 0.5) / float(opening.pictureSize.y));
  return vec2(line.from.y - plane * widening(line.from.z), line.along.y - plane * line.along.z * opening.perDepth);
}

// Where the line crosses the plane, when its distance from it grows `way`. Lines that run into the distance may never
// reach it.
float crossing(vec2 distance, float way) { return distance.y * way > 0.0 ? -distance.x / distance.y : FAR; }
// The next plane between texels, when the texel coordinates change `way`. Texels run down the picture, the plane's y axis
// up.
float nextColumn(Line line, int texel, float way) {
  return crossing(fromColumn(line, float(texel + (way > 0.0 ? 1 : 0))), way);
}
float nextRow(Line line, int texel, float way) {
  return crossing(fromRow(line, float(texel + (way > 0.0 ? 1 : 0))), -way);
}

// The part of a span where a distance that changes evenly is not negative. Without branches: lavapipe of Mesa 22.3 crashes
// on them here.
vec2 keptPositive(vec2 span, vec2 distance) {
  float at = -distance.x / distance.y;
  float low = distance.y > 0.0 ? at : distance.y == 0.0 && distance.x < 0.0 ? FAR : -FAR;
  float high = distance.y < 0.0 ? at : FAR;
  return vec2(max(span.x, low), min(span.y, high));
}

// The part of a span that shows in the opening's picture.
vec2 clippedToPicture(Line line, vec2 span) {
  span = keptPositive(span, vec2(line.from.z - opening.nearest, line.along.z));
  vec2 last = vec2(opening.pictureSize) - 0.5;
  span = keptPositive(span, fromColumn(line, -0.5));
  span = keptPositive(span, -fromColumn(line, last.x));
  span = keptPositive(span, -fromRow(line, -0.5));
  return keptPositive(span, fromRow(line, last.y));
}

vec4 faceOf(ivec2 texel) { return texelFetch(faces, clamp(texel, ivec2(0), opening.pictureSize - 1), 0); }

// The square between four texel centres.
struct Square {
  ivec2 texel;
  vec4 starts;  // depths at its corners
  uint isOpen;  // 1: the opening removes something at a corner
};

Square squareAt(ivec2 texel) {
  vec4 a = faceOf(texel), b = faceOf(texel + ivec2(1, 0)), c = faceOf(texel + ivec2(0, 1)), d = faceOf(texel + ivec2(1, 1));
  Square square;
  square.texel = texel;
  vec4 starts = vec4(a.x, b.x, c.x, d.x), contexts = vec4(a.y, b.y, c.y, d.y);
  square.isOpen = any(greaterThan(starts, contexts)) ? 1u : 0u;
  float deepest = max(max(starts.x, starts.y), max(starts.z, starts.w));
  square.starts = mix(starts, vec4(deepest), lessThan(starts, vec4(0.1 * NONE)));
  return square;
}

// mm that the line at s lies before the opening's face; negative behind it.
float beforeFace(Line line, Square square, float s) {
  if (square.isOpen == 0u) return -1.0;
  vec3 point = pointOn(line, s);
  vec2 at = clamp(texelOfPoint(point) - vec2(square.texel), 0.0, 1.0);
  return bilinear(square.starts, at) - point.z;
}

// What a square removes between s and sNext; empty where from ≥ to.
vec2 removedIn(Line line, Square square, float s, float sNext) {
  bool first = beforeFace(line, square, s) > 0.0, last = beforeFace(line, square, sNext) > 0.0;
  if (first == last) return first ? vec2(s, sNext) : vec2(FAR, FAR);
  float low = s, high = sNext;
  for (int i = 0; i < 24; ++i) {
    float middle = 0.5 * (low + high);
    if (beforeFace(line, square, middle) > 0.0 == first) low = middle;
    else high = middle;
  }
  return first ? vec2(s, low) : vec2(high, sNext);
}

// The first two parts of the line that the opening removes between two positions; FAR where there is none.
vec4 removedParts(Line line, vec2 span) {
  vec2 first = vec2(FAR), second = vec2(FAR);
  float begin = span.x, join = SLIVER * voxel;
  span = clippedToPicture(line, span);
  if (!(span.x < span.y)) return vec4(FAR);
  int most = 2 * (opening.pictureSize.x + opening.pictureSize.y) + 8;
  ivec2 last = opening.pictureSize - 1;
  // Along a line, texel coordinates grow or fall throughout.
  vec2 way = texelOfPoint(pointOn(line, span.y)) - texelOfPoint(pointOn(line, span.x));
  ivec2 stepOf = ivec2(way.x > 0.0 ? 1 : -1, way.y > 0.0 ? 1 : -1);
  ivec2 texel = clamp(ivec2(floor(texelOfPoint(pointOn(line, span.x)))), ivec2(-1), last);
  float s = span.x;
  for (int i = 0; i < most; ++i) {
    float nextX = nextColumn(line, texel.x, way.x), nextY = nextRow(line, texel.y, way.y);
    float sNext = max(min(min(nextX, nextY), span.y), s);
    vec2 removed = removedIn(line, squareAt(texel), s, sNext);
    int count = first.x == FAR ? 0 : second.x == FAR ? 1 : 2;
    if (removed.x < removed.y) {
      float end = count == 2 ? second.y : first.y;
      if (count > 0 && removed.x <= end + join) {
        if (count == 1) first.y = removed.y;
        else second.y = removed.y;
      } else if (count == 0) {
        first = removed;
      } else if (count == 1) {
        second = removed;
      }
    }
    // Two parts are all that is asked for; one, where the line does not begin in it.
    bool isEnough = second.x != FAR || (first.x != FAR && first.x > begin + join);
    float end = second.x != FAR ? second.y : first.y;
    if ((isEnough && sNext > end + join) || sNext >= span.y) break;
    s = sNext;
    texel += nextX <= nextY ? ivec2(stepOf.x, 0) : ivec2(0, stepOf.y);
    if (any(lessThan(texel, ivec2(-1))) || any(greaterThan(texel, last))) break;
  }
  return vec4(first, second);
}

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float start = hit.x, distance = FAR, factor = 1.0;
  vec2 removed = vec2(FAR);
  if (!isNone(hit.x)) {
    Ray ray = pixelRay(pixel);
    Line line = Line(opening.viewFromWorld * ray.worldBase + opening.offset, opening.viewFromWorld * ray.world);
    vec4 parts = removedParts(line, vec2(hit.x, ray.sOut));
    bool atStart = parts.x <= hit.x + SLIVER * voxel;
    start = atStart ? parts.y : hit.x;
    removed = atStart ? parts.zw : parts.xy;
    removed = max(removed, vec2(firstHole));
    // The focus is never removed.
    if (!isNone(hit.y)) {
      if (start > hit.x && start > hit.y - SKIN * voxel) start = hit.y;
      if (removed.x < hit.y && removed.y > hit.y - SKIN * voxel) removed.y = hit.y;
    }
    vec2 here = clippedToPicture(line, vec2(hit.x));
    if (here.x <= here.y) {
      vec3 point = pointOn(line, hit.x);
      vec2 texel = texelOfPoint(point);
      ivec2 corner = ivec2(floor(texel));
      vec2 at = texel - vec2(corner);
      vec4 face = mix(mix(faceOf(corner), faceOf(corner + ivec2(1, 0)), at.x),
                      mix(faceOf(corner + ivec2(0, 1)), faceOf(corner + ivec2(1, 1)), at.x), at.y);
      // Below half a pixel lies the focus's projection itself.
      if (point.z <= max(face.z, face.y) + BEHIND * voxel) distance = face.w < 0.5 ? 0.0 : face.w;
      if (EDITED) factor = editFactor(corner, at);
    }
  }
  imageStore(rayStart, pixel, vec4(start));
  imageStore(hole, pixel, vec4(removed, 0.0, 0.0));
  imageStore(distances, pixel, vec4(distance));
  if (EDITED) storeEdit(pixel, factor);
}
