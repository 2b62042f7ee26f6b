// Stage 7: the paper's equation. Output: premultiplied RGBA without background.
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform writeonly image2D picture;
layout(rgba32f) uniform readonly image2D focusLayer;
layout(rg32f) uniform readonly image2D hitPoints;
layout(r32f) uniform readonly image2D distances;
uniform vec2 widths;          // w_open, w_border in rendered pixels
uniform vec3 borderColour;
#if EDITED
layout(rg32f) uniform readonly image2D editMap;
#endif
#if CONTEXT_LAYER
layout(rgba32f) uniform readonly image2D contextLayer;
layout(r32f) uniform readonly image2D silhouette;
uniform vec3 contextColour;
uniform vec3 contextWeights;  // strength, curvature, silhouette
uniform vec2 contextShade;     // weights of illumination and of the context's own colour
layout(rgba32f) uniform readonly image2D transferTables;  // first row: emission and extinction
uniform vec2 transferMap;      // entry = stored value · x + y
uniform float curvatureScale; // mm: length that makes curvature dimensionless, the derivative volume's spacing
#endif

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
  vec4 result = imageLoad(focusLayer, pixel);
  vec2 hit = imageLoad(hitPoints, pixel).xy;
#if CONTEXT_LAYER
  vec4 context = imageLoad(contextLayer, pixel);
  if (hit.y > -1e29 && context.x > -1e29) {
    float bend = sqrt(0.5 * dot(context.xy, context.xy)) * curvatureScale;
    float rim = imageLoad(silhouette, pixel).r;
    // Edges come out as lines: both terms rise steeply.
    float opacity = contextWeights.y * smoothstep(0.10, 0.40, bend) + contextWeights.z * smoothstep(0.30, 0.85, rim);
    opacity = contextWeights.x * clamp(opacity, 0.0, 1.0);
#if EDITED
    opacity = min(opacity * imageLoad(editMap, pixel).g, 1.0);
#endif
    // A surface lies where opacity begins: what is opaque next to its value gives the colour.
    int last = imageSize(transferTables).x - 1;
    int entry = int(clamp(context.w * transferMap.x + transferMap.y + 0.5, 0.0, float(last)));
    vec4 own = vec4(0.0);
    for (int k = -1; k <= 1; ++k) own += imageLoad(transferTables, ivec2(clamp(entry + k, 0, last), 0));
    vec3 colour = own.a > 0.0 ? mix(contextColour, own.rgb / own.a, contextShade.y) : contextColour;
    colour *= mix(1.0, context.z, contextShade.x);
    result = vec4(colour, 1.0) * opacity + result * (1.0 - opacity);
  }
#endif
  if (widths.y > 0.0 && hit.x > -1e29) {
    // Share of this pixel, a box one pixel wide across the rim, that w_open < DM ≤ w_open + w_border covers.
    float distance = imageLoad(distances, pixel).r;
    float border = clamp(min(distance + 0.5, widths.x + widths.y) - max(distance - 0.5, widths.x), 0.0, 1.0);
    if (distance <= 0.0) border = 0.0;
#if EDITED
    border *= imageLoad(editMap, pixel).g;
#endif
    result = mix(result, vec4(borderColour, 1.0), border);
  }
  imageStore(picture, pixel, result);
}
