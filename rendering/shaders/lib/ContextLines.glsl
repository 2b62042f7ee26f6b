// How strong an edge of the context is at a pixel: rendering/scene/ContextLines.h.
#include "lib/Uniforms.glsl"

TEXELS_2D(rgba32f, contextLayer);
TEXELS_2D(r32f, silhouette);

const float USUAL_BEND = 0.4, LINE_FADE = 0.06;

// Dimensionless. `curvatures`: the principal ones, 1/mm.
float bendOf(vec2 curvatures) { return sqrt(0.5 * dot(curvatures, curvatures)) * contextLook.curvatureScale; }

float lineStrength(float bend, float rim) {
  float both = contextLook.curvatureWeight + contextLook.silhouetteWeight;
  float sum = contextLook.curvatureWeight * bend / (bend + USUAL_BEND) + contextLook.silhouetteWeight * rim * rim;
  return both > 0.0 ? sum / both : 0.0;
}
