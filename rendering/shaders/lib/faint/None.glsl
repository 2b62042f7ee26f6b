// Nothing stays of what the opening removes.
//
// Opacity.glsl, Colour.glsl, ScreenDoor.glsl and Lens.glsl have the same interface; `#include <faint>` names the one that the
// method needs (rendering/vocabulary/MethodStages.h and rendering/methods/clearview/ClearView.h have the formulas):
//   HAS_LENS    whether a lens says how much stays
//   faintShare  the share that stays at a pixel. `last`: of the picture; `hit`: context and focus hit
//   withFaint   a pixel's colour, premultiplied, behind what stays
//   lensLine    with HAS_LENS, how much the line around the lens darkens a pixel

const bool HAS_LENS = false;

float faintShare(ivec2 pixel, ivec2 last, vec2 hit) { return 0.0; }
vec4 withFaint(vec4 result, ivec2 pixel, float share) { return result; }
float lensLine(ivec2 pixel) { return 0.0; }
