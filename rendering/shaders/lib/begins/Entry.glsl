// A search begins where the ray enters the volume.
//
// Opening.glsl has the same interface; `#include <begins>` names the one that the picture needs:
//   Reach     what of a ray is searched: from one s to another, and again from `again` on
//   reachOf   that of a pixel's ray
#include "lib/Ray.glsl"

struct Reach {
  float from, to, again;
  uint onFocus;  // 1: the ray starts on the surface of the focus
};

Reach reachOf(ivec2 pixel, Ray ray) { return Reach(ray.sIn, ray.sOut, FAR, 0u); }
