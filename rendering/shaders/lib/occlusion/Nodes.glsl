// Ambient occlusion and the soft shadow at a point (rendering/scene/Occlusion.h; the interface is described in None.glsl).
#include <schedule>
#include "lib/Grid.glsl"
#include "lib/Uniforms.glsl"

const bool OCCLUDES = true;

// The shares of ambient and of direct light, 16 bits each, at the centres of a cell and of the next ones along x, y, and
// both: four in a texel, so that a sample takes two reads and not eight. The cells' z is below y.
UNSIGNED_TEXELS_2D(rgba32ui, occlusionNodes);

// Interpolated between the four centres of a texel, here and not by the texture unit, because graphics cards round its
// weights to 8 bits.
vec2 openBetween(uvec4 nodes, vec2 w) {
  return mix(mix(unpackUnorm2x16(nodes.x), unpackUnorm2x16(nodes.y), w.x),
             mix(unpackUnorm2x16(nodes.z), unpackUnorm2x16(nodes.w), w.x), w.y);
}

vec2 openAt(vec3 position) {
  vec3 at = clamp((voxelPosition(position) - 0.5) * lighting.nodesPerVoxel - 0.5, vec3(0.0), vec3(lighting.lastNode));
  ivec3 low = ivec3(at);
  vec3 w = at - vec3(low);
  int rows = lighting.lastNode.y + 1;
  uvec4 front = texelOf(occlusionNodes, ivec2(low.x, low.y + rows * low.z));
  uvec4 back = texelOf(occlusionNodes, ivec2(low.x, low.y + rows * min(low.z + 1, lighting.lastNode.z)));
  return mix(openBetween(front, w.xy), openBetween(back, w.xy), w.z);
}

vec2 occluded(vec2 light, vec2 open) {
  return vec2(lighting.ambient * open.x + (light.x - lighting.ambient) * open.y, light.y * open.y);
}

// A change of slope anywhere between three points, as occlusion has it from cell to cell, makes a parabola through them
// wrong by at most a sixth of the bend that they show.
float openError(vec2 front, vec2 middle, vec2 back) {
  vec2 bend = abs(front - 2.0 * middle + back);
  return dot(bend, vec2(lighting.ambient, lighting.diffuse + lighting.specular)) * (1.0 / 6.0);
}
