// An opening in which nothing is removed: rays start where they enter the volume, and see what the opening would remove as a
// ghost (lib/fading/Ghost.glsl; the interface is described in Closed.glsl).
#include <fading>
#include <hole>
#include <light>
#include <schedule>
#include "lib/PixelRay.glsl"
#include "lib/opening/CutFace.glsl"

// Not as images, of which a shader may have eight: they are read once a ray.
uniform sampler2D rayStart, hitPoints;

const bool ONLY_FOCUS = false;

Cut cutAt(ivec2 pixel, Ray ray) {
  Cut cut = Cut(ray.sIn, 0u, 0.0, vec2(0.0));
  float start = texelFetch(rayStart, pixel, 0).r;
  if (!isNone(start)) {
    vec2 hit = texelFetch(hitPoints, pixel, 0).xy;
    if (start > hit.x || !isNone(hit.y)) ghosted.end = start;
    cut.onFocus = start == hit.y && start <= ray.sIn ? 1u : 0u;
    if (APART) {
      vec2 apart = holeAt(pixel);
      ghosted.holeBegin = apart.x;
      ghosted.holeEnd = apart.y;
    }
  }
  lightByCap(cut, ray);
  return cut;
}

bool startsHere(Cut cut, Ray ray) { return ray.sIn <= ray.sOut; }
bool startsGrey(Cut cut, Ray ray) { return startsGrey(cut, ray, max(cut.start, ghosted.end)); }
