// Neither ambient occlusion nor shadows.
//
// Nodes.glsl has the same interface; `#include <occlusion>` names the one that the picture needs:
//   OCCLUDES   whether there is any
//   openAt     the shares of ambient and of direct light that reach a position (cell frame)
//   occluded   a light where only these shares of it arrive
//   openError  estimated error of the light over a part of a ray, from the shares at its front, middle and back

const bool OCCLUDES = false;

vec2 openAt(vec3 position) { return vec2(1.0); }
vec2 occluded(vec2 light, vec2 open) { return light; }
float openError(vec2 front, vec2 middle, vec2 back) { return 0.0; }
