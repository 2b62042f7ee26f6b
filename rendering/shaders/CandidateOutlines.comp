// Area, depth and centroid of the focus in a tile of a candidate image. The image's pixel middles are the corners of
// cells; where one corner of a cell's edge sees the focus and the other does not, the outline crosses the edge, and
// more rays find where. The focus in a cell is the polygon of its seeing corners and those crossings, so that the area
// changes as smoothly as the outline moves, not by whole pixels.
#include "lib/Ray.glsl"
#include "lib/Volume.glsl"
#include "lib/Crossing.glsl"
#include "lib/FocusIndex.glsl"
#include "lib/FirstHit.glsl"
#include "lib/Candidate.glsl"
#include "lib/CandidateTiles.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 4) readonly buffer Hits { vec2 hits[]; };
struct Sums {
  vec4 sums;   // area in pixels; depth, from the front and from behind, and position times area
  vec4 more;
  ivec4 box;   // x0, y0, x1, y1 of the pixels that see the focus
};
layout(std430, binding = 5) writeonly buffer Partials { Sums partials[]; };
uniform int halvings;  // of a pixel's width: how closely a crossing is found

const int LINE = 9;            // corners along a side of the tile's cells
const int ACROSS = 8 * LINE;   // edges along x, then as many along y
shared vec2 corners[LINE * LINE];
shared float crossings[2 * ACROSS];  // from the edge's first corner to its second
shared uint crossed[2 * ACROSS];     // edges to be solved, in no order
shared uint crossedCount;
shared vec4 sums[64];
shared float backs[64];
shared ivec4 boxes[64];

vec2 hitAt(uint tile, ivec2 at) {
  uint links = tiles[tile].neighbours;
  if (at.x == 8) {
    if ((links & 1u) == 0u) return vec2(NONE);
    tile += 1u;
  }
  if (at.y == 8) {
    if (links >> 1 == 0u) return vec2(NONE);
    tile += links >> 1;
  }
  return hits[64u * tile + uint((at.y & 7) * 8 + (at.x & 7))];
}

bool sees(ivec2 corner) { return !isNone(corners[corner.y * LINE + corner.x].x); }

// First corner of an edge, and the step to its second.
ivec2 cornerOf(uint edge, out ivec2 along) {
  bool across = edge < uint(ACROSS);
  along = across ? ivec2(1, 0) : ivec2(0, 1);
  int at = int(across ? edge : edge - uint(ACROSS));
  return across ? ivec2(at % 8, at / 8) : ivec2(at % LINE, at / LINE);
}

float crossingOf(uint tile, uint edge) {
  ivec2 along;
  ivec2 first = cornerOf(edge, along);
  vec2 pixel = vec2(tiles[tile].x, tiles[tile].y) + vec2(first);
  bool seen = sees(first);
  float low = 0.0, high = 1.0;
  for (int i = 0; i < halvings; ++i) {
    float middle = 0.5 * (low + high);
    Ray ray = candidateRay(tiles[tile].view, imagePosition(pixel + middle * vec2(along)));
    bool hit = meetsFocus(ray);
    if (hit == seen) low = middle;
    else high = middle;
  }
  return 0.5 * (low + high);
}

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

void main() {
  uint tile = tileOfGroup();
  if (tile >= uint(tileCount)) return;
  uint local = gl_LocalInvocationIndex;
  for (uint i = local; i < uint(LINE * LINE); i += 64u) corners[i] = hitAt(tile, ivec2(i % LINE, i / LINE));
  if (local == 0u) crossedCount = 0u;
  barrier();
  for (uint edge = local; edge < uint(2 * ACROSS); edge += 64u) {
    ivec2 along;
    ivec2 first = cornerOf(edge, along);
    if (sees(first) != sees(first + along)) crossed[atomicAdd(crossedCount, 1u)] = edge;
  }
  barrier();
  for (uint i = local; i < crossedCount; i += 64u) crossings[crossed[i]] = crossingOf(tile, crossed[i]);
  barrier();

  // Around the cell: right along its first row, down, back along the second, up.
  ivec2 cell = ivec2(gl_LocalInvocationID.xy);
  ivec2 around[4] = ivec2[4](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1));
  Polygon polygon = Polygon(vec2(0.0), vec2(0.0), vec2(0.0), 0.0, false);
  vec2 depth = vec2(0.0);
  float seeing = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 from = cell + around[i], to = cell + around[(i + 1) & 3];
    if (sees(from)) {
      add(polygon, vec2(around[i]));
      depth += corners[from.y * LINE + from.x];
      seeing += 1.0;
    }
    if (sees(from) == sees(to)) continue;
    ivec2 first = min(from, to);
    bool across = from.y == to.y;
    float at = crossings[across ? first.y * 8 + first.x : ACROSS + first.y * LINE + first.x];
    add(polygon, vec2(first - cell) + at * (across ? vec2(1.0, 0.0) : vec2(0.0, 1.0)));
  }
  sums[local] = vec4(0.0);
  backs[local] = 0.0;
  boxes[local] = ivec4(65535, 65535, -1, -1);
  ivec2 pixel = ivec2(tiles[tile].x, tiles[tile].y) + cell;
  if (seeing > 0.0) {
    add(polygon, polygon.first);
    // Positions of the image are linear in the pixel.
    vec2 middle = polygon.area > 0.0 ? polygon.moment / polygon.area : vec2(0.0);
    depth *= polygon.area / seeing;
    sums[local] = vec4(polygon.area, depth.x, imagePosition(vec2(pixel) + middle) * polygon.area);
    backs[local] = depth.y;
    if (sees(cell)) boxes[local] = ivec4(pixel, pixel);
  }
  // A tree of fixed shape: the same sums whatever runs first.
  for (uint stride = 32u; stride > 0u; stride >>= 1) {
    barrier();
    if (local < stride) {
      sums[local] += sums[local + stride];
      backs[local] += backs[local + stride];
      boxes[local] = ivec4(min(boxes[local].xy, boxes[local + stride].xy), max(boxes[local].zw, boxes[local + stride].zw));
    }
  }
  if (local == 0u) {
    partials[tile].sums = sums[0];
    partials[tile].more = vec4(backs[0], 0.0, 0.0, 0.0);
    partials[tile].box = boxes[0];
  }
}
