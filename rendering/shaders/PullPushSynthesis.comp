// Stage 2, one level down: unknown pixels take the biquadratic B-spline refinement of the coarser level (weights 9, 3, 3,
// 1 sixteenths), known ones stay bit for bit.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D fine;
uniform int fineComponent;
uniform sampler2D coarse;
layout(r32f, binding = 0) uniform writeonly image2D filled;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(filled)))) return;
  float value = texelFetch(fine, pixel, 0)[fineComponent];
  if (value < -1e29) {
    ivec2 last = textureSize(coarse, 0) - 1;
    ivec2 nearest = pixel >> 1;
    ivec2 neighbour = clamp(nearest + 2 * (pixel & 1) - 1, ivec2(0), last);
    value = (9.0 * texelFetch(coarse, nearest, 0).r +
             3.0 * (texelFetch(coarse, ivec2(neighbour.x, nearest.y), 0).r +
                    texelFetch(coarse, ivec2(nearest.x, neighbour.y), 0).r) +
             texelFetch(coarse, neighbour, 0).r) / 16.0;
  }
  imageStore(filled, pixel, vec4(value));
}
