// What the opening removes: rays run from the context's first hit to where stage 4 lets them start, and show all of it, or with
// LABELS_ALONE the labels that are never cut away (the interface is described in Closed.glsl).
#include <importance>
#include <schedule>
#include "lib/PixelRay.glsl"

// Not as images, of which a shader may have eight: they are read once a ray.
uniform sampler2D rayStart, hitPoints;

const bool ONLY_FOCUS = LABELS_ALONE == 1;

struct Cut {
  float start;   // mm along the ray
  uint onFocus;
};

Cut cutAt(ivec2 pixel, Ray ray) { return Cut(texelFetch(hitPoints, pixel, 0).x, MAY_START_ON_FOCUS); }
// Where the ray starts to see the rest; not beyond cut.start where nothing is removed.
float endAt(ivec2 pixel, Ray ray) { return min(texelFetch(rayStart, pixel, 0).r, ray.sOut); }
bool startsHere(Cut cut, Ray ray) { return !isNone(cut.start) && cut.start < ray.sOut; }
vec2 behindCut(vec2 unchanged, Cut cut, float s) { return unchanged; }
