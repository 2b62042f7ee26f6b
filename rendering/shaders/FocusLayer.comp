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
#include "lib/Stretch.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
#if EXPLODED
layout(rgba32f) uniform image2D focusLayer;
#else
layout(rgba32f) uniform writeonly image2D focusLayer;
#endif

#if LISTED
ivec2 pixelOf(int i) { return listedPixel(i); }
#elif QUINCUNX
ivec2 pixelOf(int i) { return quincunxPixel(RAYS, i); }
#else
uniform int pitch;  // pixels from one ray to the next

// The rays of an invocation are those of pixels one below the other.
ivec2 pixelOf(int i) { return pitch * (regionPixel() * ivec2(1, RAYS) + ivec2(0, i)); }
#endif

#if CLIPPED == 2
bool showsVolume(Cut cut, Ray ray) { return startsHere(cut, ray) && !startsGrey(cut, ray); }
vec4 seenOn(Walk walk) {
  bool grey = startsHere(walk.cut, walk.ray) && startsGrey(walk.cut, walk.ray);
  return grey ? greyOf(walk.ray) : colourOf(walk);
}
#else
bool showsVolume(Cut cut, Ray ray) { return startsHere(cut, ray); }
vec4 seenOn(Walk walk) { return colourOf(walk); }
#endif

#if EXPLODED
// One stretch of a ray of an exploded view, behind those that the layer holds already; RAYS is 1.
void main() {
  ivec2 pixel = pixelOf(0);
  vec4 before = mix(vec4(0.0), imageLoad(focusLayer, pixel), bvec4(resumes == 1));
  Ray ray = pixelRay(pixel);
  vec2 stretch = stretchOf(pixel);
  Cut cut = cutOf(ray, stretch.x);
  ray.sOut = min(ray.sOut, stretch.y);
  bool goesOn = hasRay(pixel) && cut.start <= ray.sOut && 1.0 - before.a >= integral.leastTransmittance;
  if (!goesOn) cut.start = ray.sIn;
#if CLIPPED == 2
  bool grey = goesOn && startsGrey(cut, ray);
#else
  const bool grey = false;
#endif
  Walk walks[RAYS];
  walks[0] = walkFrom(ray, cut, goesOn && !grey);
  integrate(walks);
  vec4 seen = colourOf(walks[0]);
#if CLIPPED == 2
  if (grey) seen = greyOf(ray);
#endif
  imageStore(focusLayer, pixel, over(before, seen));
}
#elif APART && FADING != 3
// A ray may see nothing on a part of its way; RAYS is 1.
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
    if (part == 1) cut = behindHole(cut, pixel, removed.y);
    Walk walks[RAYS];
    walks[0] = walkFrom(ray, cut, visible && cut.start <= ray.sOut);
    integrate(walks);
    colour = over(colour, part == 0 ? seenOn(walks[0]) : colourOf(walks[0]));
  }
  imageStore(focusLayer, pixel, colour);
}
#else
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
#endif
