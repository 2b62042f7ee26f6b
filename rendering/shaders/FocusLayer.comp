// Stage 5: emission–absorption integral from the ray start to the exit of the box, front to back.
// Output: premultiplied RGBA.
#include <integral>
#include <opening>
#include <pixels>
#include "lib/ColourOfRay.glsl"
#include "lib/PixelRay.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D focusLayer;

void main() {
  Walk walks[RAYS];
  for (int i = 0; i < RAYS; ++i) {
    ivec2 pixel = pixelOf(i);
    Ray ray = pixelRay(pixel);
    Cut cut = cutAt(pixel, ray);
    walks[i] = walkFrom(ray, cut, showsVolume(cut, ray) && hasRay(pixel));
  }
  integrate(walks);
  for (int i = 0; i < RAYS; ++i) imageStore(focusLayer, pixelOf(i), seenOn(walks[i]));
}
