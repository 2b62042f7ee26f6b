// Cones, last step: where each ray starts to see, before the brush.
#include <level>
#include <schedule>
#include "lib/Cones.glsl"
#include "lib/None.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rg32f, hitPoints);

// Every second bit, from the lowest on, of 16.
int everySecond(int bits) {
  bits &= 0x5555;
  bits = (bits | (bits >> 1)) & 0x3333;
  bits = (bits | (bits >> 2)) & 0x0f0f;
  return (bits | (bits >> 4)) & 0x00ff;
}

// Depth at which the pixel's ray leaves the last cone, where that is behind `least`; else `least`. Squares are visited depth
// first, and of the four parts of a square the one on the pixel's side first: near cones rule out most of the others. A square
// is its place in that order within a top square, bits of x and y in turns, and for each level whether its parts are mirrored.
float deepestCone(ivec2 pixel, float least) {
  ivec2 at = pixel - cones.origin, tops = cones.tops, fromEnd = ivec2(greaterThan(2 * at, tops << CONE_TOP));
  int level = CONE_TOP, place = 0;
  ivec2 top = ivec2(0), mirrored = ivec2(0);
  float best = least;
  do {
    int below = CONE_TOP - level;
    ivec2 within = ivec2(everySecond(place), everySecond(place >> 1)) ^ (mirrored >> level);
    ivec2 square = ((top + fromEnd * (tops - 1 - 2 * top)) << below) + within;
    float deepest = coneDepths[coneLevel(below) + square.y * (tops.x << below) + square.x];
    ivec2 low = square << level, high = low + (1 << level) - 1;
    float fall = cones.slope * length(vec2(max(max(low - at, at - high), 0)));
    float bound = (deepest - fall) / (1.0 + fall * cones.perDepth);
    bool isDeeper = bound > best, isPixel = level == 0;
    if (isDeeper && isPixel) best = bound;
    if (isDeeper && !isPixel) {
      --level;
      place <<= 2;
      ivec2 isBehindMiddle = ivec2(greaterThanEqual(at, low + (1 << level)));
      mirrored = (mirrored & ~(1 << level)) | (isBehindMiddle << level);
    } else {
      // The next square of the level, or of the coarsest one that ends here.
      ++place;
      int up = min(findLSB(place) >> 1, below);
      place >>= 2 * up;
      level += up;
      if (level == CONE_TOP) {
        place = 0;
        ++top.x;
        if (top.x == tops.x) top = ivec2(0, top.y + 1);
      }
    }
  } while (top.y < tops.y);
  return best;
}

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, rays.pictureSize))) return;
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float start = hit.x;
  if (!isNone(hit.x)) {
    float sOut = pixelRay(pixel).sOut;
    if (!isNone(hit.y)) {
      start = hit.y;
    } else {
      float context = depthAtPosition(pixel, hit.x), deepest = deepestCone(pixel, context);
      if (deepest > context) start = positionAtDepth(pixel, deepest);
    }
    start = clamp(start, hit.x, max(hit.x, sOut));
  }
  storeStart(pixel, hit, start);
}
