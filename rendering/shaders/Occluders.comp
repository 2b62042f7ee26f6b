// The medium that casts shadows, first step: the mean extinction of each cell as the volume is cut open.
// rendering/scene/Occlusion.h defines it. An invocation a cell: x, and y and z one below the other.
#include <schedule>
#include "lib/Clip.glsl"
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"
#if OPENED
#include "lib/PixelRay.glsl"
TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, rayStart);
#endif

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 4) readonly buffer OccluderCells { vec4 extinctions[]; };  // context, kept, exempt; 1/mm
layout(r32f) uniform writeonly image2D medium;                                      // 1/mm, a cell a texel, z below y

// What is left of the context at a place in cell coordinates.
#if OPENED
float visibleShare(vec3 place) {
  vec3 point = occluders.viewFromCells * place + occluders.offset;
  vec2 ndc = point.xy / (rays.halfSize * (1.0 + point.z * occluders.perDepth));
  ivec2 pixel = ivec2(floor(vec2(rays.pictureSize) * (0.5 + 0.5 * vec2(ndc.x, -ndc.y))));
  bool shown = point.z >= occluders.nearest && all(greaterThanEqual(pixel, ivec2(0))) &&
               all(lessThan(pixel, rays.pictureSize));
  if (!shown) return 1.0;
  float start = texelOf(rayStart, pixel).r, context = texelOf(hitPoints, pixel).x;
  if (isNone(start)) return 1.0;
  float open = clamp((start - context) / occluders.width, 0.0, 1.0);
  return 1.0 - open * clamp((start - positionAtDepth(pixel, point.z)) / occluders.width + 0.5, 0.0, 1.0);
}
#else
float visibleShare(vec3 place) { return 1.0; }
#endif

// What clipping leaves there.
float clippedShare(vec3 place) {
  float share = 1.0;
#if CLIPPED
  vec3 position = place * occluders.side + 0.5;
  for (int i = 0; i < HALF_SPACES; ++i) {
    float before = dot(clipping.planes[i].xyz, position) + clipping.planes[i].w;
    // Planes that are not in use have no normal.
    bool used = dot(clipping.normals[i].xyz, clipping.normals[i].xyz) > 0.5;
    share *= used ? clamp(before / occluders.width + 0.5, 0.0, 1.0) : 1.0;
  }
#endif
  return share;
}

void main() {
  ivec2 at = regionPixel();
  if (at.x >= occluders.dims.x || at.y >= occluders.dims.y * occluders.dims.z) return;
  ivec3 cell = ivec3(at.x, at.y % occluders.dims.y, at.y / occluders.dims.y);
  int index = at.x + occluders.dims.x * at.y;
  vec3 extinction = extinctions[index].xyz;
  float sum = 0.0;
  if (extinction.x + extinction.y + extinction.z > 0.0) {
    for (int i = 0; i < 8; ++i) {
      vec3 place = vec3(cell) + vec3(0.2637, 0.2289, 0.2673) + 0.5 * vec3(i & 1, (i >> 1) & 1, i >> 2);
      sum += mix(extinction.z, visibleShare(place) * extinction.x + extinction.y, clippedShare(place));
    }
  }
  imageStore(medium, at, vec4(0.125 * sum));
}
