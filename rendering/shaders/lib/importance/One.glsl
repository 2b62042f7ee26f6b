// Rays are opened to the focus alone.
//
// Levels.glsl has the same interface; `#include <importance>` names the one that the look needs:
//   ontoFocus           the focus's field where a ray starts on the surface that it is opened to, on whichever side of it
//                       rounding has put the start; `range`: of the field, what is in focus
//   MAY_START_ON_FOCUS  whether a ray through what the opening removes may start there, as Cut has it

const uint MAY_START_ON_FOCUS = 0u;

float ontoFocus(float field, vec2 range) { return clamp(field, range.x, range.y); }
