// Stage 5, in front of the focus layer: what the opening removes of the labels that are never cut away, as part of the
// context, where `<focus>` is their index; or all that it removes. Output: premultiplied RGBA.
#include <integral>
#include <opening>
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D protectedLayer;

void main() {
  ivec2 pixel = regionPixel();
  Ray ray = pixelRay(pixel);
  Cut cut = cutAt(pixel, ray);
  ray.sOut = endAt(pixel, ray);
  Walk walks[RAYS];
  walks[0] = walkFrom(ray, cut, startsHere(cut, ray) && hasRay(pixel));
  integrate(walks);
  imageStore(protectedLayer, pixel, colourOf(walks[0]));
}
