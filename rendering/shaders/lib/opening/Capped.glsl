// No opening, but clipped: rays start where they enter what is kept, some of them on a capped face (the interface is
// described in Closed.glsl).
#include <focus>
#include <volume>
#include "lib/Traversal.glsl"
#include "lib/opening/CutFace.glsl"

const bool ONLY_FOCUS = false;

bool startsInFocus(Ray ray) {
  ivec3 cell = cellAt(ray, ray.sIn);
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  vec3 position = cellPosition(ray, ray.sIn);
  float field = focusAt(held, clamp(position - vec3(cell), 0.0, 1.0), storedExact(position));
  vec2 range = focusRange();
  return mayHoldFocus(held) && field >= range.x && field <= range.y;
}

// In grey faces the focus shows as it is. A face of a part of an exploded view shows no grey where the focus is left out of it.
Cut cutOf(Ray ray, float s, const bool inFocus) {
  Cut cut = Cut(s, inFocus ? 1u : 0u, 0.0, vec2(0.0));
  lightByCap(cut, ray);
  if (GREY_FACES && !inFocus) cut.onFocus = startsInFocus(ray) ? 1u : 0u;
  return cut;
}
Cut cutAt(ivec2 pixel, Ray ray) { return cutOf(ray, ray.sIn, false); }
bool startsHere(Cut cut, Ray ray) { return ray.sIn <= ray.sOut; }
bool startsGrey(Cut cut, Ray ray) { return startsGrey(cut, ray, cut.start); }
