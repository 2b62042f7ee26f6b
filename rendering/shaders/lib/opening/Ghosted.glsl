// An opening in which nothing is removed: rays start where they enter the volume, and see what the opening would remove as a
// ghost (lib/Ghosting.glsl; the interface is described in Closed.glsl).
#include <light>
#include <schedule>
#include "lib/Fading.glsl"
#include "lib/PixelRay.glsl"
#include "lib/opening/CutFace.glsl"

// Not as images, of which a shader may have eight: they are read once a ray.
uniform sampler2D rayStart, hitPoints;
#if APART
uniform sampler2D hole;  // of an opening that another camera cuts (RemovedParts.comp)
#endif

const bool ONLY_FOCUS = false;

Cut cutAt(ivec2 pixel, Ray ray) {
  Cut cut = Cut(ray.sIn, 0u, 0.0, vec2(0.0));
  float start = texelFetch(rayStart, pixel, 0).r;
  if (!isNone(start)) {
    vec2 hit = texelFetch(hitPoints, pixel, 0).xy;
    if (start > hit.x || !isNone(hit.y)) ghosted.end = start;
    cut.onFocus = start == hit.y && start <= ray.sIn ? 1u : 0u;
#if APART
    vec2 apart = texelFetch(hole, pixel, 0).xy;
    ghosted.holeBegin = apart.x;
    ghosted.holeEnd = apart.y;
#endif
  }
#if CLIPPED
  lightByCap(cut, ray);
#endif
  return cut;
}

bool startsHere(Cut cut, Ray ray) { return ray.sIn <= ray.sOut; }
