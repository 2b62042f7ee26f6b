// Stage 4 before the brush: rays start where the filled focus and the distance map let them, at the centres of pixels.
//
// BlendScattered.glsl and Given.glsl have the same interface; `#include <starts>` names the one that the method needs:
//   uneditedStart  where a ray starts to see. `hit`: context and focus hit of the pixel, the first not NONE; `sOut`: where
//                  its ray leaves the box
//   storeBorder    stores the distance that the line around the opening goes by, for scattered rays
#include <schedule>
#include "lib/starts/BlendedStart.glsl"

TEXELS_2D(r32f, focusFilled);
TEXELS_2D(r32f, distances);

float distanceAt(ivec2 pixel) { return texelOf(distances, pixel).r; }
float filledAt(ivec2 pixel) { return texelOf(focusFilled, pixel).r; }

void storeBorder(ivec2 pixel, vec2 hit) {}
