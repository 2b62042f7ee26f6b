// Stage 5: emission–absorption integral from the ray start to the exit of the box, front to back (midpoint rule).
// Output: premultiplied RGBA.
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
#endif

#if SHADING
uniform sampler3D gradientTexture; // world normal · ½ + ½, and the root of the magnitude over gradientUnit
uniform vec2 gradientGate;         // magnitudes (in w) between which lighting fades in: flat regions have no normal
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
bool inFocus(uint slot, vec3 position, float stored) {
  ivec3 cell = ivec3(position);
  return focusIndicator(focusCorners(slot, cell), position - vec3(cell)) >= 0.5;
}
#elif FOCUS_KIND == 2
bool inFocus(uint slot, vec3 position, float stored) {
  return stored >= focusLow && stored <= focusHigh && focusCellKept(slot, ivec3(position));
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

vec4 integrate(Ray ray, float start) {
  vec3 colour = vec3(0.0);
  float transmittance = 1.0;
  float end = ray.sOut;
  vec3 perCell = 1.0 / vec3(volumeDims);
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
      bool focus = slot != 0u && inFocus(slot, at, stored);
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
      // 1 - exp(-x) by its series where x is small: the difference would cancel.
      float depth = material.a * stepLength;
      float alpha = depth < 1e-3 ? depth * (1.0 - 0.5 * depth) : 1.0 - exp(-depth);
      vec3 shade = material.rgb;
#if SHADING
      vec4 gradient = texture(gradientTexture, uvw);
      vec3 normal = gradient.xyz * 2.0 - 1.0;
      float gate = smoothstep(gradientGate.x, gradientGate.y, gradient.w);
#if FOCUS_KIND == 1
      if (focus) {
        vec3 smoothed = focusNormal(at);
        if (dot(smoothed, smoothed) > 1e-6) {
          normal = smoothed;
          gate = 1.0;
        }
      }
#endif
      float size = dot(normal, normal);
      if (size > 1e-4) shade = mix(shade * (lighting.x + 0.7 * lighting.y), lit(shade, normal * inversesqrt(size), ray.world), gate);
#endif
      colour += transmittance * alpha * shade;
      transmittance *= 1.0 - alpha;
      if (transmittance < 1.0 - OPAQUE) return vec4(colour, 1.0 - transmittance);
    }
  }
  return vec4(colour, 1.0 - transmittance);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, pictureSize))) return;
  Ray ray = pixelRay(pixel);
  vec4 result = vec4(0.0);
#if HAS_RAY_START
  float start = texelFetch(rayStart, pixel, 0).r;
  if (!isNone(start)) result = integrate(ray, start);
#else
  if (ray.sIn <= ray.sOut) result = integrate(ray, ray.sIn);
#endif
  imageStore(focusLayer, pixel, result);
}
