// A picture of few pixels over its background, enlarged by a cubic B-spline: four linearly filtered texels hold the
// sixteen (Sigg and Hadwiger, "Fast third-order texture filtering", GPU Gems 2, 2005). A spline neither overshoots nor
// shows the pixels as a linear filter does.
#include "lib/Background.glsl"

in vec2 at;
out vec4 colour;
uniform sampler2D picture;

void main() {
  vec2 size = vec2(textureSize(picture, 0)), position = at * size - 0.5, first = floor(position), f = position - first, g = 1.0 - f;
  vec2 w0 = g * g * g / 6.0, w1 = 2.0 / 3.0 - 0.5 * f * f * (2.0 - f), w3 = f * f * f / 6.0;
  vec2 low = w0 + w1, high = 1.0 - low;
  vec2 a = (first - 0.5 + w1 / low) / size, b = (first + 1.5 + w3 / high) / size;
  colour = overBackground(low.y * (low.x * texture(picture, a) + high.x * texture(picture, vec2(b.x, a.y))) +
                          high.y * (low.x * texture(picture, vec2(a.x, b.y)) + high.x * texture(picture, b)), at.y);
}
