// A search begins where an opening lets the ray start, and leaves out the hole behind that where another camera cuts it (the
// interface is described in Entry.glsl).
#include <hole>
#include "lib/Ray.glsl"

// Not as images, of which a shader may have eight: they are read once a ray.
uniform sampler2D rayStart, hitPoints;

struct Reach {
  float from, to, again;
  uint onFocus;
};

Reach reachOf(ivec2 pixel, Ray ray) {
  float start = texelFetch(rayStart, pixel, 0).r;
  bool none = isNone(start);
  uint onFocus = start == texelFetch(hitPoints, pixel, 0).y ? 1u : 0u;
  vec2 hole = APART ? holeAt(pixel) : vec2(FAR);
  float from = max(start, ray.sIn);
  return Reach(none ? FAR : from, min(hole.x, ray.sOut), none ? FAR : max(hole.y, from), onFocus);
}
