// Nothing lies in front of the focus layer.
//
// ProtectedLabels.glsl has the same interface; `#include <front>` names the one that the picture needs:
//   withFront  a pixel's colour, premultiplied, behind what lies in front

vec4 withFront(vec4 result, ivec2 pixel) { return result; }
