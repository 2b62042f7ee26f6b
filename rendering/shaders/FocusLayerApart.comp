// Stage 5 where another camera cuts the opening: a ray may see nothing on a part of its way. RAYS is 1.
// Output: premultiplied RGBA.
#include <hole>
#include <integral>
#include <opening>
#include <pixels>
#include "lib/ColourOfRay.glsl"
#include "lib/PixelRay.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D focusLayer;

Cut behindHole(ivec2 pixel, float end) {
  return Cut(end, end == texelFetch(hitPoints, pixel, 0).y ? 1u : 0u, 0.0, vec2(0.0));
}

void main() {
  ivec2 pixel = pixelOf(0);
  Ray ray = pixelRay(pixel);
  Cut cut = cutAt(pixel, ray);
  vec2 removed = holeAt(pixel);
  bool visible = showsVolume(cut, ray) && hasRay(pixel);
  float sOut = ray.sOut;
  vec4 colour = vec4(0.0);
  for (int part = 0; part < 2; ++part) {
    ray.sOut = part == 0 ? min(sOut, removed.x) : sOut;
    if (part == 1) cut = behindHole(pixel, removed.y);
    Walk walks[RAYS];
    walks[0] = walkFrom(ray, cut, visible && cut.start <= ray.sOut);
    integrate(walks);
    colour = over(colour, part == 0 ? seenOn(walks[0]) : colourOf(walks[0]));
  }
  imageStore(focusLayer, pixel, colour);
}
