// No opening, but clipped: rays start where they enter what is kept, some of them on a capped face (the interface is
// described in Closed.glsl).
#include "lib/opening/CutFace.glsl"

const bool ONLY_FOCUS = false;

Cut cutAt(ivec2 pixel, Ray ray) {
  Cut cut = Cut(ray.sIn, 0u, 0.0, vec2(0.0));
  lightByCap(cut, ray);
  return cut;
}
bool startsHere(Cut cut, Ray ray) { return ray.sIn <= ray.sOut; }
