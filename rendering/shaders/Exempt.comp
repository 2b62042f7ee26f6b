// Labels that are never clipped, before and behind what is kept of each ray; rendering/passes/ExemptPass.h defines it.
// `<focus>` is their index here. Output: the picture with them, premultiplied RGBA.
#include <integral>
#include <opening>
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D exempted;
uniform sampler2D picture;

void main() {
  ivec2 pixel = regionPixel();
  bool inPicture = hasRay(pixel);
  Ray whole = wholePixelRay(pixel), kept = whole;
  clipToHalfSpaces(kept);
  bool anyKept = kept.sIn <= kept.sOut;
  vec4 colour = vec4(0.0);
  for (int part = 0; part < 2; ++part) {
    Ray ray = whole;
    if (part == 0) ray.sOut = anyKept ? kept.sIn : whole.sOut;
    else ray.sIn = anyKept ? kept.sOut : whole.sOut;
    Walk walks[RAYS];
    walks[0] = walkFrom(ray, Cut(ray.sIn, 0u), inPicture && ray.sIn < ray.sOut);
    integrate(walks);
    colour = over(colour, colourOf(walks[0]));
    if (part == 0) colour = over(colour, texelFetch(picture, min(pixel, textureSize(picture, 0) - 1), 0));
  }
  imageStore(exempted, pixel, colour);
}
