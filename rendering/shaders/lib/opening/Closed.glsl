// No opening: rays start where they enter the volume.
//
// Capped.glsl, Open.glsl and Removed.glsl have the same interface; `#include <opening>` names the one that the scene needs:
//   Cut         where and how a ray starts
//   cutAt       the cut of a pixel's ray
//   startsHere  whether the ray has anything to see
//   behindCut   the light at s, near the face that the opening cut
//   ONLY_FOCUS  whether only what `<focus>` holds shows, with the context's own colours
#include "lib/Ray.glsl"

const bool ONLY_FOCUS = false;

struct Cut {
  float start;   // mm along the ray
  uint onFocus;  // 1: the ray starts on the focus's surface
};

Cut cutAt(ivec2 pixel, Ray ray) { return Cut(ray.sIn, 0u); }
bool startsHere(Cut cut, Ray ray) { return ray.sIn <= ray.sOut; }
vec2 behindCut(vec2 unchanged, Cut cut, float s) { return unchanged; }
