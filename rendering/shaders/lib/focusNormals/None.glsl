// The focus is lit by the volume's normals.
//
// Smoothed.glsl and SmoothedAlong.glsl have the same interface; `#include <focusNormals>` names the one that the scene needs:
//   OWN_NORMALS        whether the focus has normals of its own
//   FLAT_FOCUS         square of their length (1/mm) below which a point lies too deep in the focus to have its normal
//   focusNormal        the focus's normal at a position (cell frame), not normalised; not in SmoothedAlong.glsl
//   focusNormalsAlong  the same along a straight path through a cell, Bernstein coefficients; not in Smoothed.glsl

const bool OWN_NORMALS = false;
const float FLAT_FOCUS = 0.0;

vec3 focusNormal(vec3 position) { return vec3(0.0); }
void focusNormalsAlong(ivec3 cell, vec3 a, vec3 b, out vec3 along[4]) {
  for (int k = 0; k < 4; ++k) along[k] = vec3(0.0);
}
