// All edges count alike.
//
// Opened.glsl has the same interface; `#include <edges>` names the one that the picture needs:
//   contrasts         from which on a pixel has a weight, and at which it is 1
//   greatestContrast  the greatest of a pixel's contrasts to the four beside
#include "lib/edges/Contrasts.glsl"

float greatestContrast(vec4 contrast, ivec2 pixel, ivec2 beside[4]) { return highest(contrast); }
