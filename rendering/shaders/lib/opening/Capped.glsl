// No opening, but clipped: rays start where they enter what is kept, some of them on a capped face (the interface is
// described in Closed.glsl).
#include <focus>
#include "lib/Traversal.glsl"
#include "lib/Volume.glsl"
#include "lib/opening/CutFace.glsl"

const bool ONLY_FOCUS = false;

#if CLIPPED == 2
bool startsInFocus(Ray ray) {
  ivec3 cell = cellAt(ray, ray.sIn);
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  vec3 position = cellPosition(ray, ray.sIn);
  float field = focusAt(held, clamp(position - vec3(cell), 0.0, 1.0), storedExact(position));
  vec2 range = focusRange();
  return mayHoldFocus(held) && field >= range.x && field <= range.y;
}
#endif

Cut cutAt(ivec2 pixel, Ray ray) {
  Cut cut = Cut(ray.sIn, 0u, 0.0, vec2(0.0));
  lightByCap(cut, ray);
#if CLIPPED == 2
  cut.onFocus = startsInFocus(ray) ? 1u : 0u;
#endif
  return cut;
}
bool startsHere(Cut cut, Ray ray) { return ray.sIn <= ray.sOut; }
