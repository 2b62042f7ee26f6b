// Cones, last step: where each ray starts to see, before the brush.
#include "lib/Cones.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rg32f, hitPoints);
layout(r32f) uniform writeonly image2D coneStart;

const int CONE_TOP = 4;

// One coordinate of a square from its place among the squares of a top square: its bits stand in every second pair.
int everySecondPair(int bits) { return (bits & 3) | ((bits >> 2) & 12) | ((bits >> 4) & 48) | ((bits >> 6) & 192); }

// Depth at which the pixel's ray leaves the last cone, where that is behind `least`; else `least`. Squares are visited depth
// first, from the side of the region that the pixel lies on: near cones, which rule out most others, come first. A square of
// `level` is the top square `top` and, within it, `place`: pairs of bits of x and y in turns.
float deepestCone(ivec2 pixel, float least) {
  ivec2 at = pixel - cones.origin, tops = cones.size >> (2 * CONE_TOP);
  int area = cones.size.x * cones.size.y;
  ivec2 fromEnd = ivec2(greaterThan(2 * at, cones.size));
  int level = CONE_TOP, place = 0;
  ivec2 top = ivec2(0);
  float best = least;
  do {
    ivec2 squares = cones.size >> (2 * level);
    ivec2 square = (top << (2 * (CONE_TOP - level))) + ivec2(everySecondPair(place), everySecondPair(place >> 2));
    square += fromEnd * (squares - 1 - 2 * square);
    int begin = (level > 0 ? area : 0) + (level > 1 ? area >> 4 : 0) + (level > 2 ? area >> 8 : 0) +
                (level > 3 ? area >> 12 : 0);
    float deepest = coneDepths[begin + square.y * squares.x + square.x];
    ivec2 low = square << (2 * level), high = low + (1 << (2 * level)) - 1;
    float fall = cones.slope * length(vec2(max(max(low - at, at - high), 0)));
    float bound = (deepest - fall) / (1.0 + fall * cones.perDepth);
    bool isDeeper = bound > best, isPixel = level == 0;
    if (isDeeper && isPixel) best = bound;
    if (isDeeper && !isPixel) {
      --level;
      place <<= 4;
    } else {
      // The next square of the level, or of the coarsest one that ends here.
      ++place;
      int up = min(findLSB(place) >> 2, CONE_TOP - level);
      place >>= 4 * up;
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
  imageStore(coneStart, pixel, vec4(start));
}
