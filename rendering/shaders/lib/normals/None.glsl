// No gated normals, in unlit pictures.
//
// Gradient.glsl and Spline.glsl have the same interface; `#include <normals>` names the one that the scene needs. Gated
// normals (rendering/scene/Lighting.h) say how a surface in the volume faces.
//   gatedAt           the gated normal at a voxel; with texels, that is, not with a spline
//   gatedCoefficient  a coefficient of the gated normals, at an index; with a spline alone

vec3 gatedAt(ivec3 voxel) { return vec3(0.0); }
vec3 gatedCoefficient(ivec3 index) { return vec3(0.0); }
