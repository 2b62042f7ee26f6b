// Stage 7: the paper's equation. Output: premultiplied RGBA without background.
#include <schedule>
#include "lib/None.glsl"
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"
#if CONTEXT_LAYER
#include "lib/TransferTables.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D picture;
TEXELS_2D(rgba32f, focusLayer);
TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, distances);

// Pixels across the box that a ray stands for.
#if SCATTERED
const float BOX = 0.2;
#else
const float BOX = 1.0;
#endif

#if EDITED
TEXELS_2D(rg32f, editMap);
#endif
#if PROTECTED
// A sampler under either schedule: with it, the images would be more than the eight that OpenGL guarantees.
uniform sampler2D protectedLayer;
#endif
// A share of what the opening removes stays: 1 less opaque, 2 also grey, 3 on some of the pixels, 4 as a lens has it.
#if FAINT
uniform sampler2D faintLayer;
#if FAINT == 4
uniform sampler2D lensSurface;  // LensPass; a sampler as protectedLayer is
uniform vec3 lens;                // 1/mm of its radius; bends; rim
uniform int lensFade;             // LensFade (rendering/scene/Method.h, which has the formula)

// How far out a place is, in radii, along the context's surface; beyond anything where that has no place before the focus.
float placeInLens(ivec2 pixel) {
  float distance = texelFetch(lensSurface, pixel, 0).w;
  return isNone(distance) ? FAR : distance * lens.x;
}

float faintShare(ivec2 pixel, vec2 hit) {
  vec3 normal = texelFetch(lensSurface, pixel, 0).xyz, bend = vec3(0.0);
  ivec2 last = imageSize(picture) - 1;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = (i & 2) == 0 ? ivec2(1, 0) : ivec2(0, 1);
    ivec2 beside = clamp((i & 1) == 0 ? pixel + step : pixel - step, ivec2(0), last);
    bend += abs(texelFetch(lensSurface, beside, 0).xyz - normal);
  }
  float place = placeInLens(pixel), kept = clamp(place, 0.0, 1.0);
  if (lensFade != 0 && place < 1.0)
    kept = lensFade == 1 ? 0.0 : isNone(hit.y) ? 1.0 : clamp((hit.y - hit.x) * lens.x, 0.0, 1.0);
  return clamp(max(length(bend) * lens.y, kept), 0.0, 1.0);
}
#else
uniform float faintOpacity;
#endif

#if FAINT == 3
// Bayer's matrix of 8×8 (rendering/scene/Method.h).
float faintShare(ivec2 pixel, vec2 hit) {
  int odd = pixel.x ^ pixel.y, rank = 0;
  for (int bit = 0; bit < 3; ++bit) rank = (rank << 2) | (((odd >> bit) & 1) << 1) | ((pixel.y >> bit) & 1);
  return (float(rank) + 0.5) / 64.0 < faintOpacity ? 1.0 : 0.0;
}
#elif FAINT < 3
float faintShare(ivec2 pixel, vec2 hit) { return faintOpacity; }
#endif
#endif
#if APART
uniform sampler2D rayStart;
#endif
#if CONTEXT_LAYER
TEXELS_2D(rgba32f, contextLayer);
TEXELS_2D(r32f, silhouette);
#endif

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
  vec4 result = texelOf(focusLayer, pixel);
  vec2 hit = texelOf(hitPoints, pixel).xy;
#if FAINT
  float share = faintShare(pixel, hit);
  vec4 faint = texelFetch(faintLayer, pixel, 0) * share;
#if FAINT == 2
  faint.rgb = vec3(dot(faint.rgb, vec3(0.2126, 0.7152, 0.0722)));  // ITU-R BT.709
#endif
  result = faint + (1.0 - faint.a) * result;
#endif
#if PROTECTED
  vec4 front = texelFetch(protectedLayer, pixel, 0);
  result = front + (1.0 - front.a) * result;
#endif
#if CONTEXT_LAYER
  vec4 context = texelOf(contextLayer, pixel);
  bool isRemoved = !isNone(hit.y);
#if APART
  isRemoved = isRemoved && texelFetch(rayStart, pixel, 0).r > hit.x;
#endif
  if (isRemoved && !isNone(context.x)) {
    float bend = sqrt(0.5 * dot(context.xy, context.xy)) * contextLook.curvatureScale;
    float rim = texelOf(silhouette, pixel).r;
    // Edges come out as lines: both terms rise steeply.
    float opacity = contextLook.curvatureWeight * smoothstep(0.10, 0.40, bend);
    opacity = contextLook.strength * clamp(opacity + contextLook.silhouetteWeight * smoothstep(0.30, 0.85, rim), 0.0, 1.0);
#if EDITED
    opacity = min(opacity * texelOf(editMap, pixel).g, 1.0);
#endif
#if FAINT == 4
    opacity *= 1.0 - share;
#endif
    // A surface lies where opacity begins: what is opaque next to its value gives the colour.
    float entry = floor(clamp(entryOf(context.w) + 0.5, 0.0, LAST_ENTRY));
    vec4 own = materialAt(entry - 1.0) + materialAt(entry) + materialAt(entry + 1.0);
    vec3 colour = own.a > 0.0 ? mix(contextLook.colour, own.rgb / own.a, contextLook.valueWeight) : contextLook.colour;
    colour *= mix(1.0, context.z, contextLook.illuminationWeight);
    result = vec4(colour, 1.0) * opacity + result * (1.0 - opacity);
  }
#endif
  if (!isNone(hit.x)) {
    // Share of this ray's box across the rim that w_open < DM ≤ w_open + w_border covers.
    float distance = texelOf(distances, pixel).r, inner = cutaway.widths.x, outer = inner + cutaway.widths.y;
    float border = clamp((min(distance + 0.5 * BOX, outer) - max(distance - 0.5 * BOX, inner)) / BOX, 0.0, 1.0);
    if (distance <= 0.0) border = 0.0;
#if EDITED
    border *= texelOf(editMap, pixel).g;
#endif
    result = mix(result, vec4(cutaway.borderColour, 1.0), border);
#if FAINT == 4
    float line = 0.5 * (1.0 - clamp(abs(placeInLens(pixel) - 1.0) * lens.z, 0.0, 1.0));
#if EDITED
    line *= texelOf(editMap, pixel).g;
#endif
    result.rgb = max(result.rgb - result.a * line, 0.0);
#endif
  }
  imageStore(picture, pixel, result);
}
