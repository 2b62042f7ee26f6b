// Stage 7: the paper's equation. Output: premultiplied RGBA without background.
#include <contextLayer>
#include <edits>
#include <faint>
#include <front>
#include <schedule>
#include "lib/None.glsl"
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D picture;
TEXELS_2D(rgba32f, focusLayer);
TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, distances);

// Pixels across the box that a ray stands for.
const float BOX = SCATTERED == 1 ? 0.2 : 1.0;

void main() {
  ivec2 pixel = regionPixel();
  ivec2 size = imageSize(picture);
  if (any(greaterThanEqual(pixel, size))) return;
  vec4 result = texelOf(focusLayer, pixel);
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float share = faintShare(pixel, size - 1, hit);
  result = withFaint(result, pixel, share);
  result = withFront(result, pixel);
  result = withContextLayer(result, pixel, hit, share);
  if (!isNone(hit.x)) {
    // Share of this ray's box across the rim that w_open < DM ≤ w_open + w_border covers.
    float distance = texelOf(distances, pixel).r, inner = cutaway.widths.x, outer = inner + cutaway.widths.y;
    float border = clamp((min(distance + 0.5 * BOX, outer) - max(distance - 0.5 * BOX, inner)) / BOX, 0.0, 1.0);
    if (distance <= 0.0) border = 0.0;
    if (EDITED) border *= editAt(pixel).y;
    result = mix(result, vec4(cutaway.borderColour, 1.0), border);
    if (HAS_LENS) {
      float line = lensLine(pixel);
      if (EDITED) line *= editAt(pixel).y;
      result.rgb = max(result.rgb - result.a * line, 0.0);
    }
  }
  imageStore(picture, pixel, result);
}
