// Stage 5: emission–absorption integral from the ray start to the exit of the box, front to back.
// Output: premultiplied RGBA.
#include <integral>
#include <opening>
#include "lib/PixelRay.glsl"
#if LISTED
#include "lib/PixelList.glsl"
#else
#include "lib/Region.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D focusLayer;

#if LISTED
ivec2 pixelOf(int i) { return listedPixel(i); }
#else
uniform int pitch;  // pixels from one ray to the next

// The rays of an invocation are those of pixels one below the other.
ivec2 pixelOf(int i) { return pitch * (regionPixel() * ivec2(1, RAYS) + ivec2(0, i)); }
#endif

void main() {
  Walk walks[RAYS];
  for (int i = 0; i < RAYS; ++i) {
    ivec2 pixel = pixelOf(i);
    Ray ray = pixelRay(pixel);
    Cut cut = cutAt(pixel, ray);
    walks[i] = walkFrom(ray, cut, startsHere(cut, ray) && all(lessThan(pixel, rays.pictureSize)));
  }
  integrate(walks);
  for (int i = 0; i < RAYS; ++i) imageStore(focusLayer, pixelOf(i), colourOf(walks[i]));
}
