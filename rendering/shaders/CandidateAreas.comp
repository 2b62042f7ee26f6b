// Area, depth and centroid of the focus in a tile of a candidate image. The image's pixel middles are the corners of
// cells. The focus in a cell is the polygon of its seeing corners and of where the outline crosses its edges, so that
// the area changes as smoothly as the outline moves, not by whole pixels.
#include "lib/CandidateSums.glsl"
#include "lib/CandidateTiles.glsl"
#include "lib/None.glsl"

layout(local_size_x = 8, local_size_y = 8) in;  // rows of a tile, tiles
layout(std430, binding = 4) readonly buffer Hits { vec2 hits[]; };
layout(std430, binding = 5) writeonly buffer Partials { Sums partials[]; };
layout(std430, binding = 7) readonly buffer Crossings { float crossings[]; };
layout(std430, binding = 6) readonly buffer Ends { uint ends[]; };  // bit 0: from the front; bit 1: from behind; with END_FACES

// Area and first moments of a polygon, point by point.
struct Polygon {
  vec2 first, last, moment;
  float area;
  bool begun;
};
void add(inout Polygon polygon, vec2 point) {
  if (polygon.begun) {
    float twice = polygon.last.x * point.y - polygon.last.y * point.x;
    polygon.area += 0.5 * twice;
    polygon.moment += (polygon.last + point) * (twice / 6.0);
  } else {
    polygon.first = point;
    polygon.begun = true;
  }
  polygon.last = point;
}

// Adds up what a cell holds: around it right along its first row, down, back along the second, up.
void addCell(uint tile, ivec2 cell, inout Sums all) {
  ivec2 around[4] = ivec2[4](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1));
  uint pixels[4];
  vec2 corners[4];
  for (int i = 0; i < 4; ++i) {
    pixels[i] = pixelOf(tile, cell + around[i]);
    corners[i] = pixels[i] == NOWHERE ? vec2(NONE) : hits[pixels[i]];
  }
  Polygon polygon = Polygon(vec2(0.0), vec2(0.0), vec2(0.0), 0.0, false);
  vec2 depth = vec2(0.0), through = vec2(0.0);
  float seeing = 0.0;
  for (int i = 0; i < 4; ++i) {
    int next = (i + 1) & 3;
    if (!isNone(corners[i].x)) {
      add(polygon, vec2(around[i]));
      depth += corners[i];
      if (END_FACES) through += vec2(ends[pixels[i]] & 1u, ends[pixels[i]] >> 1);
      seeing += 1.0;
    }
    if (isNone(corners[i].x) == isNone(corners[next].x)) continue;
    // An edge belongs to its upper or left end.
    int first = i < 2 ? i : next;
    float at = crossings[2u * pixels[first] + uint(i & 1)];
    add(polygon, vec2(around[first]) + at * ((i & 1) == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0)));
  }
  if (seeing == 0.0) return;
  add(polygon, polygon.first);
  // Positions of the image are linear in the pixel.
  ivec2 place = placeOf(pixels[0]);
  vec2 middle = polygon.area > 0.0 ? polygon.moment / polygon.area : vec2(0.0);
  depth *= polygon.area / seeing;
  all.sums += vec4(polygon.area, depth.x, imagePosition(vec2(place) + middle) * polygon.area);
  all.more.x += depth.y;
  if (END_FACES) all.more.yz += through * (polygon.area / seeing);
  if (!isNone(corners[0].x)) all.box = ivec4(min(all.box.xy, place), max(all.box.zw, place));
}

void main() {
  uint tile = 8u * tileOfGroup() + gl_LocalInvocationID.y;
  uint row = gl_LocalInvocationID.x;
  Sums all = noSums();
  if (tile < uint(tileCount))
    for (int x = 0; x < 8; ++x) addCell(tile, ivec2(x, row), all);
  all = sumOver(all, row, 8u);
  if (row == 0u && tile < uint(tileCount)) partials[tile] = all;
}
