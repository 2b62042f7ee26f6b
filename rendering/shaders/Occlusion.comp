// The medium that casts shadows, second step: the shares of ambient and of direct light that reach the centre of each cell.
// rendering/scene/Occlusion.h defines it. An invocation has CELLS cells, one behind the other along z: four,
// because a vec4 holds a number for each.
#include <schedule>
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(r32f, medium);  // 1/mm, a cell a texel, z below y
// A row a direction, those all around first: through which cells a ray from a cell's centre goes, counted from that cell,
// and the weight of each, mm. All cells are alike, so that it is the same for each. Behind the last one is a weight of 0.
TEXELS_2D(rgba32f, steps);
layout(r32ui) uniform writeonly uimage2D nodeValues;  // 16 bits each

const float OPAQUE = 14.0;  // optical depth: less than 1e-6 passes

bool isWithin(int at, int count) { return uint(at) < uint(count); }

// The medium of CELLS cells from one on; 0 outside.
vec4 mediumFrom(ivec3 cell) {
  bool beside = isWithin(cell.x, occlusion.dims.x) && isWithin(cell.y, occlusion.dims.y);
  vec4 found;
  for (int i = 0; i < CELLS; ++i) {
    int z = cell.z + i;
    float texel = texelOf(medium, ivec2(cell.x, cell.y + occlusion.dims.y * z)).r;
    found[i] = beside && isWithin(z, occlusion.dims.z) ? texel : 0.0;
  }
  return found;
}

// From the centres of CELLS cells in the direction of a row of steps.
vec4 transmittances(ivec3 cell, int row) {
  vec4 depths = vec4(0.0);
  int i = 0;
  bool goes = true;
  do {
    if (goes) {
      vec4 next = texelOf(steps, ivec2(i, row));
      ivec3 at = cell + ivec3(next.xyz);
      depths += next.w * mediumFrom(at);
      ++i;
      // What has left the volume does not come back.
      bool isInside = isWithin(at.x, occlusion.dims.x) && isWithin(at.y, occlusion.dims.y) &&
                      at.z < occlusion.dims.z && at.z > -CELLS;
      goes = isInside && next.w > 0.0 && min(min(depths.x, depths.y), min(depths.z, depths.w)) < OPAQUE;
    }
  } while (goes);
  return exp(-depths);
}

// Whether something may show within one cell of one of CELLS centres.
bvec4 areNeeded(ivec3 cell) {
  vec4 sums = vec4(0.0);
  for (int i = 0; i < 9; ++i) {
    ivec3 beside = cell + ivec3(i % 3, i / 3, 1) - 1;
    vec4 middle = mediumFrom(beside);
    float before = mediumFrom(beside - ivec3(0, 0, 1)).x, behind = mediumFrom(beside + ivec3(0, 0, 1)).w;
    sums += middle + vec4(before, middle.xyz) + vec4(middle.yzw, behind);
  }
  return greaterThan(sums, vec4(0.0));
}

void main() {
  ivec2 pixel = regionPixel();
  ivec3 cell = ivec3(pixel.x, pixel.y % occlusion.dims.y, CELLS * (pixel.y / occlusion.dims.y));
  if (any(greaterThanEqual(cell, occlusion.dims))) return;
  bvec4 needed = areNeeded(cell);
  vec4 around = vec4(1.0), direct = vec4(1.0);
  if (any(needed)) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < occlusion.around; ++i) sum += transmittances(cell, i);
    if (occlusion.around > 0) around = min(2.0 * sum / float(occlusion.around), 1.0);
    sum = vec4(0.0);
    for (int i = 0; i < occlusion.towardsLight; ++i) sum += transmittances(cell, occlusion.around + i);
    if (occlusion.towardsLight > 0) direct = sum / float(occlusion.towardsLight);
  }
  for (int i = 0; i < CELLS; ++i) {
    vec2 open = 1.0 - occlusion.strength * (1.0 - vec2(around[i], direct[i]));
    ivec2 texel = ivec2(cell.x, cell.y + occlusion.dims.y * (cell.z + i));
    if (cell.z + i < occlusion.dims.z) imageStore(nodeValues, texel, uvec4(packUnorm2x16(needed[i] ? open : vec2(1.0))));
  }
}
