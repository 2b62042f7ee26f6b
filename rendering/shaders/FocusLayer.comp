// Stage 5: emission–absorption integral from the ray start to the exit of the box, front to back (midpoint rule).
// Output: premultiplied RGBA.
#include "lib/Region.glsl"
#include "lib/Ray.glsl"
#include "lib/Volume.glsl"
#include "lib/FocusIndex.glsl"
#include "lib/Lighting.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform writeonly image2D focusLayer;

uniform usampler3D occupiedSkip;   // Chebyshev distance in bricks to the nearest one that shows anything
uniform sampler2D transferTable;   // colour, extinction (1/mm), one row
uniform vec2 transferMap;          // table position = stored value · x + y
uniform float stepLength;          // mm

#if HAS_RAY_START
uniform sampler2D rayStart;
uniform sampler2D hitPoints;
#endif

#if SHADING
uniform sampler3D gradientTexture; // gated normals (rendering/scene/Lighting.h), zero at 511/1023
uniform vec3 gradientOrigin;       // cell frame position of its first texel's outer corner; beyond it all is flat
uniform float certainLength;       // of a gated normal, from which on it is lit in full
uniform float meanIncidence;       // |n·l| where there is no normal
#if HAS_RAY_START
uniform float wallDepth;           // mm behind a cut face over which its own normal gives way to the gradient's
uniform float wallShare;           // of a cut face's light that is the face's own at its surface
#endif
#endif

#if FOCUS_KIND != 0
uniform vec4 focusProperties;      // colour, extinction (1/mm)
#endif
#if FOCUS_KIND == 1 && FOCUS_PALETTE
uniform usampler3D focusPaletteIndex;
uniform ivec3 focusOrigin;         // index of the palette texture's first voxel
uniform sampler2D focusPalette;     // colours, one row
#endif
#if FOCUS_KIND == 1 && SHADING
uniform sampler3D focusSmooth;     // smoothed indicator around the focus
uniform vec3 focusSmoothOrigin;    // cell frame position of its first texel's outer corner
uniform mat3 worldFromIndexGradient;
#endif

// Opacity beyond which nothing behind shows: what is left is below half a step of 8 bits.
const float OPAQUE = 1.0 - 1.0 / 512.0;

#if FOCUS_KIND == 1
bool inFocus(uint slot, ivec3 cell, vec3 position, float stored) {
  return focusIndicator(focusCorners(slot, cell), position - vec3(cell)) >= 0.5;
}
#elif FOCUS_KIND == 2
bool inFocus(uint slot, ivec3 cell, vec3 position, float stored) {
  return stored >= focusLow && stored <= focusHigh && focusCellKept(slot, cell);
}
#endif

#if FOCUS_KIND == 1 && SHADING
vec3 focusNormal(vec3 position) {
  vec3 size = vec3(textureSize(focusSmooth, 0));
  vec3 at = (position - focusSmoothOrigin) / size, e = 1.0 / size;
  vec3 g = vec3(texture(focusSmooth, at + vec3(e.x, 0, 0)).r - texture(focusSmooth, at - vec3(e.x, 0, 0)).r,
                texture(focusSmooth, at + vec3(0, e.y, 0)).r - texture(focusSmooth, at - vec3(0, e.y, 0)).r,
                texture(focusSmooth, at + vec3(0, 0, e.z)).r - texture(focusSmooth, at - vec3(0, 0, e.z)).r);
  return worldFromIndexGradient * g;
}
#endif

#if SHADING && HAS_RAY_START
// Normal of the cut face at a pixel, from its neighbours' ray starts; zero where the ray does not start on a cut face.
vec3 wallNormal(ivec2 pixel, float start) {
  vec2 hit = texelFetch(hitPoints, pixel, 0).xy;
  if (!isNone(hit.y) || start <= hit.x + 0.5 * wallDepth) return vec3(0.0);
  vec3 tangent[2];
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = ivec2(1 - axis, axis);
    ivec2 a = max(pixel - step, ivec2(0)), b = min(pixel + step, pictureSize - 1);
    float sa = texelFetch(rayStart, a, 0).r, sb = texelFetch(rayStart, b, 0).r;
    if (isNone(sa) || isNone(sb)) return vec3(0.0);
    tangent[axis] = worldPosition(pixelRay(b), sb) - worldPosition(pixelRay(a), sa);
  }
  vec3 n = cross(tangent[0], tangent[1]);
  float size = length(n);
  return size > 0.0 ? n / size : vec3(0.0);
}
#endif

// 1 - exp(-x), by its series where the difference would cancel.
float opacityOf(float depth) {
  return depth < 1e-2 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
}

vec4 integrate(Ray ray, float start, vec3 wall) {
  vec3 colour = vec3(0.0);
  float transmittance = 1.0, opticalDepth = 0.0;
  bool cut = dot(wall, wall) > 0.0;
  float end = ray.sOut;
  vec3 perCell = 1.0 / vec3(volumeDims);
#if SHADING
  vec3 perGradientTexel = 1.0 / vec3(textureSize(gradientTexture, 0));
#endif
  int count = int(ceil((end - start) / stepLength - 0.5));
  for (int k = 0; k < count;) {
    vec3 position = cellPosition(ray, start + (float(k) + 0.5) * stepLength);
    ivec3 brick = clamp(ivec3(position), ivec3(0), volumeDims) >> 3;
    int empty = int(texelFetch(occupiedSkip, brick, 0).r);
    int reach = max(empty, 1);
    int axis;
    float leave = blockExit(ray, (brick - (reach - 1)) * 8, (brick + reach) * 8, axis);
    // Samples keep their places whatever is skipped, so that skipping never changes the picture.
    int kEnd = clamp(int(ceil((leave - start) / stepLength - 0.5)), k + 1, count);
    if (empty > 0) {
      k = kEnd;
      continue;
    }
#if FOCUS_KIND != 0
    uint slot = texelFetch(focusBricks, brick, 0).r;
#endif
    for (; k < kEnd; ++k) {
      vec3 at = cellPosition(ray, start + (float(k) + 0.5) * stepLength);
      vec3 uvw = (at - 0.5) * perCell;
      float stored = texture(volumeTexture, uvw).r * texelScale;
      vec4 material;
#if FOCUS_KIND != 0
      // A sample on the brick's face is kept from reading the neighbour's cells under this brick's slot.
      ivec3 cell = clamp(ivec3(at), brick * 8, brick * 8 + 7);
      bool focus = slot != 0u && inFocus(slot, cell, at, stored);
      if (focus) {
        material = focusProperties;
#if FOCUS_KIND == 1 && FOCUS_PALETTE
        uint entry = texelFetch(focusPaletteIndex, ivec3(floor(at - 0.5)) - focusOrigin, 0).r;
        material.rgb = texelFetch(focusPalette, ivec2(entry, 0), 0).rgb;
#endif
      } else
#endif
      {
        float entry = clamp(stored * transferMap.x + transferMap.y, 0.0, float(TABLE_SIZE - 1));
        material = texelFetch(transferTable, ivec2(int(entry + 0.5), 0), 0);
      }
      if (material.a <= 0.0) continue;
      float depth = material.a * stepLength;
      float alpha = opacityOf(depth);
      vec3 shade = material.rgb;
#if SHADING
      vec3 homogeneous = material.rgb * (lighting.x + meanIncidence * lighting.y);
      vec3 normal = texture(gradientTexture, (at - gradientOrigin) * perGradientTexel).xyz * (1023.0 / 511.0) - 1.0;
      float certainty = smoothstep(0.0, certainLength, length(normal));
#if FOCUS_KIND == 1
      if (focus) {
        vec3 smoothed = focusNormal(at);
        if (dot(smoothed, smoothed) > 1e-6) {
          normal = smoothed;
          certainty = 1.0;
        }
      }
#endif
      float size = dot(normal, normal);
      shade = size > 1e-4 ? mix(homogeneous, lit(material.rgb, normal * inversesqrt(size), ray.world), certainty) : homogeneous;
#if HAS_RAY_START
      // A cut face is lit as the face it is; what lies under it, by its own gradient.
      if (cut) {
        float share = wallShare * exp(-(float(k) + 0.5) * stepLength / wallDepth);
        shade = mix(shade, lit(material.rgb, wall, ray.world), share);
      }
#endif
#endif
      colour += transmittance * alpha * shade;
      transmittance *= 1.0 - alpha;
      opticalDepth += depth;
      if (transmittance < 1.0 - OPAQUE) return vec4(colour, 1.0 - transmittance);
    }
  }
  return vec4(colour, opacityOf(opticalDepth));
}

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, pictureSize))) return;
  Ray ray = pixelRay(pixel);
  vec4 result = vec4(0.0);
#if HAS_RAY_START
  float start = texelFetch(rayStart, pixel, 0).r;
#if SHADING
  vec3 wall = isNone(start) ? vec3(0.0) : wallNormal(pixel, start);
#else
  vec3 wall = vec3(0.0);
#endif
  if (!isNone(start)) result = integrate(ray, start, wall);
#else
  if (ray.sIn <= ray.sOut) result = integrate(ray, ray.sIn, vec3(0.0));
#endif
  imageStore(focusLayer, pixel, result);
}
