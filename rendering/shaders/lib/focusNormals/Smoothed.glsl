// A focus of labels is lit by the gradient of a smoothed indicator, at points (the interface is described in None.glsl).
#include "lib/Grid.glsl"
#include "lib/Uniforms.glsl"

uniform sampler3D focusSmooth;  // the indicator, filtered

const bool OWN_NORMALS = true;
const float FLAT_FOCUS = 1e-6;

// The indicator's gradient (1/mm).
vec3 focusNormal(vec3 position) {
  vec3 size = vec3(textureSize(focusSmooth, 0));
  vec3 at = (voxelPosition(position) - focus.smoothOrigin) / size, e = 1.0 / size;
  vec3 g = vec3(textureLod(focusSmooth, at + vec3(e.x, 0, 0), 0.0).r - textureLod(focusSmooth, at - vec3(e.x, 0, 0), 0.0).r,
                textureLod(focusSmooth, at + vec3(0, e.y, 0), 0.0).r - textureLod(focusSmooth, at - vec3(0, e.y, 0), 0.0).r,
                textureLod(focusSmooth, at + vec3(0, 0, e.z), 0.0).r - textureLod(focusSmooth, at - vec3(0, 0, e.z), 0.0).r);
  return focus.worldFromIndexGradient * g;
}
