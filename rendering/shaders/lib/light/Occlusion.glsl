// Ambient occlusion and the soft shadow at a point (rendering/scene/Occlusion.h).
//
// OCCLUDED is 0 in pictures without either: nothing of this file is compiled then.
#ifndef OCCLUDED
#define OCCLUDED 0
#endif
#if OCCLUDED
#include "lib/Grid.glsl"
#include "lib/light/BlinnPhong.glsl"

// What is left of ambient and of direct light at the centre of each cell, 16 bits each. Not a texture: of those that a
// shader may have, none is free, and on a graphics card filtering would round the weights.
layout(std430, binding = 6) readonly buffer OcclusionNodeValues { uint nodeValues[]; };

vec2 nodeAt(uint index) { return unpackUnorm2x16(nodeValues[index]); }

// What is left of ambient and of direct light at a position in the cell frame.
vec2 openAt(vec3 position) {
  vec3 at = clamp((voxelPosition(position) - 0.5) * lighting.nodesPerVoxel - 0.5, vec3(0.0), vec3(lighting.lastNode));
  ivec3 low = ivec3(at);
  vec3 w = at - vec3(low);
  uvec3 dims = uvec3(lighting.lastNode) + 1u, next = min(uvec3(lighting.lastNode - low), uvec3(1u)) * uvec3(1u, dims.x, dims.x * dims.y);
  uint first = uint(low.x) + dims.x * (uint(low.y) + dims.y * uint(low.z));
  vec2 x0 = mix(nodeAt(first), nodeAt(first + next.x), w.x);
  vec2 x1 = mix(nodeAt(first + next.y), nodeAt(first + next.y + next.x), w.x);
  vec2 x2 = mix(nodeAt(first + next.z), nodeAt(first + next.z + next.x), w.x);
  vec2 x3 = mix(nodeAt(first + next.z + next.y), nodeAt(first + next.z + next.y + next.x), w.x);
  return mix(mix(x0, x1, w.y), mix(x2, x3, w.y), w.z);
}

// The same light where so much of it is left.
vec2 occluded(vec2 light, vec2 open) {
  return vec2(lighting.ambient * open.x + (light.x - lighting.ambient) * open.y, light.y * open.y);
}
#endif
