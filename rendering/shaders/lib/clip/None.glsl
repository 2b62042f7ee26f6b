// Nothing clips the volume.
//
// Faces.glsl and GreyFaces.glsl have the same interface; `#include <clip>` names the one that the picture needs:
//   CLIPS             whether anything clips
//   GREY_FACES        whether capped faces show values in grey
//   clipToHalfSpaces  shortens a ray to what is kept of it, and finds the capped face that it enters by
//   capNormal         the normal of that face, where there is one
//   keptShare         how much is kept of what lies within half a `width` (mm) around a position
#include "lib/Ray.glsl"

const bool CLIPS = false, GREY_FACES = false;

void clipToHalfSpaces(inout Ray ray) {}
vec3 capNormal(Ray ray) { return vec3(0.0); }
float keptShare(vec3 position, float width) { return 1.0; }
