// Gated normals as a spline (the interface is described in None.glsl).
#include <schedule>

TEXELS_3D(rgb10_a2, normalTexels);  // coefficients, in the places of those of the volume's spline

vec3 gatedCoefficient(ivec3 index) { return texelOf(normalTexels, index).xyz; }
