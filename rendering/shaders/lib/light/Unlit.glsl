// No lighting: colours are shown as they are. The interface is that of Lit.glsl.

#include "lib/Fading.glsl"

#undef OCCLUDED
#define OCCLUDED 0

const bool LIT = false;
const vec2 UNLIT = vec2(1.0, 0.0);  // shaded colour = colour · x + y

struct CellNormals {
#if FADING
  Slopes slopes;
#else
  float none;
#endif
};

vec2 lightOf(vec3 normal, vec3 rayDirection) { return UNLIT; }
vec3 gatedAt(ivec3 voxel) { return vec3(0.0); }
vec2 lightOfGated(vec3 gated, vec3 rayDirection) { return UNLIT; }
vec2 lightOfFocus(vec3 gated, vec3 position, vec3 rayDirection) { return UNLIT; }
#if !FADING
CellNormals normalsAlong(ivec3 cell, vec3 a, vec3 b) { return CellNormals(0.0); }
struct NormalsAlong {
  float none;
};
NormalsAlong normalsAlongSpline(ivec3 cell, vec3 a, vec3 b) { return NormalsAlong(0.0); }
CellNormals halfOf(NormalsAlong normals, int each) { return CellNormals(0.0); }
#elif SPLINE
struct NormalsAlong {
  SplineSlopes slopes;
};
NormalsAlong normalsAlongSpline(ivec3 cell, vec3 a, vec3 b) {
  return NormalsAlong(slopesAlongSpline(cell, a, b));
}
CellNormals halfOf(NormalsAlong normals, int each) {
  return CellNormals(halfOf(normals.slopes, each));
}
#else
CellNormals normalsAlong(ivec3 cell, vec3 a, vec3 b) {
  vec3 f[8];
  return CellNormals(slopesAlong(cell, a, b, f));
}
#endif
void addFocusNormals(inout CellNormals normals, ivec3 cell, vec3 a, vec3 b) {}
vec2 lightAlong(CellNormals normals, float u, vec3 rayDirection, bool ofFocus) { return UNLIT; }
float intensityOf(vec2 light) { return 1.0; }
float nextTurn(CellNormals normals, float u) { return 1.0; }
float piecesOfLight(CellNormals normals, float from, float to, bool ofFocus, vec3 rayDirection, float weight) {
  return 0.0;
}
