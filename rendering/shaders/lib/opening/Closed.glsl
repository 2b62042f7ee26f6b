// No opening: rays start where they enter the volume.
//
// Capped.glsl, Open.glsl, Ghosted.glsl, Removed.glsl and Exempt.glsl have the same interface; `#include <opening>` names the one
// that the picture needs:
//   Cut         where and how a ray starts
//   cutAt       the cut of a pixel's ray; not in Exempt.glsl
//   startsHere  whether the ray has anything to see; not in Exempt.glsl
//   behindCut   the light at s, near the face that the opening cut
//   ONLY_FOCUS  whether only what `<focus>` holds shows, with the context's own colours
// The first four also have
//   startsGrey, greyOf  whether a ray starts on a capped face that shows grey, and that face's colour
// and the first two
//   cutOf       the cut of a ray that starts at s, in the focus or not: a stretch of an exploded view
#include "lib/Ray.glsl"

const bool ONLY_FOCUS = false;

struct Cut {
  float start;   // mm along the ray
  uint onFocus;  // 1: the ray starts on the focus's surface
};

Cut cutAt(ivec2 pixel, Ray ray) { return Cut(ray.sIn, 0u); }
Cut cutOf(Ray ray, float s, const bool inFocus) { return Cut(s, 1u); }
bool startsHere(Cut cut, Ray ray) { return ray.sIn <= ray.sOut; }
bool startsGrey(Cut cut, Ray ray) { return false; }
vec4 greyOf(Ray ray) { return vec4(0.0); }
vec2 behindCut(vec2 unchanged, Cut cut, float s) { return unchanged; }
