// Stage 2, one level down: unknown pixels take the biquadratic B-spline refinement of the coarser level (weights 9, 3, 3,
// 1 sixteenths), known ones stay bit for bit.
layout(local_size_x = 8, local_size_y = 8) in;
#include "lib/PullPush.glsl"
layout(r32f) uniform readonly image2D coarse;
layout(r32f, binding = 0) uniform writeonly image2D filled;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(filled)))) return;
  float value = fineValue(pixel);
  if (value < -1e29) {
    ivec2 last = imageSize(coarse) - 1;
    ivec2 nearest = pixel >> 1;
    ivec2 neighbour = clamp(nearest + 2 * (pixel & 1) - 1, ivec2(0), last);
    value = (9.0 * imageLoad(coarse, nearest).r +
             3.0 * (imageLoad(coarse, ivec2(neighbour.x, nearest.y)).r +
                    imageLoad(coarse, ivec2(nearest.x, neighbour.y)).r) +
             imageLoad(coarse, neighbour).r) / 16.0;
  }
  imageStore(filled, pixel, vec4(value));
}
