// A picture of few pixels over its background, enlarged by the cubic filter of Mitchell and Netravali ("Reconstruction filters
// in computer graphics", 1988) with B = C = 1/3. It leaves less error than a cubic B-spline, which blurs, and shows the pixels
// less than a linear filter does (tests/bench/results/motion.md). rendering/Enlargement.cpp does the same on the CPU.
#include "lib/Background.glsl"

in vec2 at;
out vec4 colour;
uniform sampler2D picture;

// Weights of the texels from the one before the first to the second one behind it; `f`: from the first to the place.
vec4 weights(float f) {
  vec4 x = abs(f - vec4(-1.0, 0.0, 1.0, 2.0)), near = ((7.0 * x - 12.0) * x * x + 16.0 / 3.0) / 6.0;
  vec4 far = (((-7.0 / 3.0 * x + 12.0) * x - 20.0) * x + 32.0 / 3.0) / 6.0;
  return mix(far, near, lessThan(x, vec4(1.0)));
}

void main() {
  ivec2 size = textureSize(picture, 0);
  vec2 position = at * vec2(size) - 0.5, first = floor(position);
  vec4 across = weights(position.x - first.x), down = weights(position.y - first.y), sum = vec4(0.0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      sum += across[i] * down[j] * texelFetch(picture, clamp(ivec2(first) + ivec2(i, j) - 1, ivec2(0), size - 1), 0);
  colour = overBackground(sum, at.y);
}
