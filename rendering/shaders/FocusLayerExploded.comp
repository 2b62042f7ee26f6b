// Stage 5 of an exploded view (rendering/scene/Explosion.h): one stretch of each ray, behind those that the layer holds already.
// A stretch lies in a part, before or behind the focus's first hit, or in the focus; the rays of a part are those of a camera
// moved back by as much as the part is moved. RAYS is 1. Output: premultiplied RGBA.
#include <integral>
#include <opening>
#include <pixels>
#include <shown>
#include <stretch>
#include "lib/PixelRay.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform image2D focusLayer;
uniform int resumes;  // 1: the layer holds stretches that lie before this one; 0: it holds anything

void main() {
  ivec2 pixel = pixelOf(0);
  vec4 before = mix(vec4(0.0), imageLoad(focusLayer, pixel), bvec4(resumes == 1));
  Ray ray = pixelRay(pixel);
  vec2 stretch = stretchOf(pixel);
  Cut cut = cutOf(ray, max(ray.sIn, stretch.x), FOCUS_ALONE);
  ray.sOut = min(ray.sOut, stretch.y);
  bool goesOn = hasRay(pixel) && cut.start <= ray.sOut && 1.0 - before.a >= integral.leastTransmittance;
  if (!goesOn) cut.start = ray.sIn;
  bool grey = goesOn && startsGrey(cut, ray);
  Walk walks[RAYS];
  walks[0] = walkFrom(ray, cut, goesOn && !grey);
  integrate(walks);
  vec4 seen = colourOf(walks[0]);
  if (grey) seen = greyOf(ray);
  imageStore(focusLayer, pixel, over(before, seen));
}
