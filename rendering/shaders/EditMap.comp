// The brush: how far strokes move each ray's start, and how much of the context layer and the border they leave (what a
// stroke does is defined in rendering/settings/BrushStroke.h). Output: offset in mm along the ray; factor of the context
// layer's opacity where the ray meets the focus, of the border's elsewhere.
#include <schedule>
#include <starts>
#include "lib/None.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rg32f) uniform writeonly image2D editMap;
TEXELS_2D(rg32f, hitPoints);

struct Stroke {
  uint mode;
  uint coversFocus;
  float radius;    // mm
  float softness;  // share of the radius
  float effect;    // mm, or the share of the context layer
  uint toSurface;
  float unused[2];
};
// A straight line on the picture: x, y and radius in pixels, and view depth in mm behind the rays' anchor plane.
struct Line {
  vec4 from, to;
  uvec4 stroke;  // index of its stroke
};
layout(std430, binding = 0) readonly buffer Strokes { Stroke strokes[]; };
layout(std430, binding = 1) readonly buffer Lines { Line lines[]; };
// Where each tile's list begins, one more than there are tiles; then the lists: indices of lines, in painting order.
layout(std430, binding = 2) readonly buffer Tiles { uint tiles[]; };
uniform int tileSize;  // pixels a side
uniform int tilesAcross, tileCount;

const uint RESTORE = 0u, OPEN = 1u, FADE = 2u;

// How far beyond [low, high] s lies.
float excess(float s, float low, float high) { return max(max(low - s, s - high), 0.0); }

float profile(float d, float softness) {
  if (softness <= 0.0) return d <= 1.0 ? 1.0 : 0.0;
  float x = clamp((1.0 - d) / softness, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float offset = 0.0, share = 1.0;
  if (!isNone(hit.x)) {
    bool meetsFocus = !isNone(hit.y);
    float sOut = pixelRay(pixel).sOut, farthest = max(hit.x, meetsFocus ? hit.y : sOut);
    float unedited = uneditedStart(pixel, hit, sOut), start = unedited;
    vec2 place = placeOf(pixel);
    ivec2 tileAt = ivec2(place) / tileSize;
    int tile = tileAt.y * tilesAcross + tileAt.x;
    uint next = tiles[tile], end = tiles[tile + 1];
    while (next < end) {
      // One stroke: the greatest weight over its lines here.
      uint index = lines[tiles[tileCount + 1 + next]].stroke.x;
      Stroke stroke = strokes[index];
      float weight = 0.0;
      for (; next < end; ++next) {
        Line line = lines[tiles[tileCount + 1 + next]];
        if (line.stroke.x != index) break;
        vec2 along = line.to.xy - line.from.xy, from = place - line.from.xy;
        float size2 = dot(along, along);
        vec4 nearest = mix(line.from, line.to, size2 > 0.0 ? clamp(dot(from, along) / size2, 0.0, 1.0) : 0.0);
        float painted = profile(length(place - nearest.xy) / nearest.z, stroke.softness);
        if (painted <= weight) continue;
        float s = positionAtDepth(pixel, nearest.w);
        float off = excess(s, hit.x, stroke.mode == OPEN ? max(unedited, start) : hit.x);
        weight = max(weight, painted * (1.0 - smoothstep(1.0, 2.0, off / stroke.radius)));
      }
      float change = stroke.effect * weight;
      if (stroke.mode == RESTORE || stroke.mode == OPEN) {
        if (stroke.mode == OPEN)
          start = min(start + change, farthest);
        else if (!meetsFocus || stroke.coversFocus != 0u)
          start = stroke.toSurface != 0u ? mix(start, hit.x, weight) : max(start - change, hit.x);
        if (!meetsFocus) share *= 1.0 - weight;
      } else if (meetsFocus) {
        share *= stroke.mode == FADE ? 1.0 - change : 1.0 + change;
      }
    }
    offset = start - unedited;
    if (meetsFocus && start < unedited) share *= (start - hit.x) / (unedited - hit.x);
  }
  imageStore(editMap, pixel, vec4(offset, share, 0.0, 0.0));
}
