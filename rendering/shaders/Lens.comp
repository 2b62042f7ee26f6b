// What ClearView's lens reads of the context's first surface. Output: its unit normal along the view's right, up and forward, 0
// where there is none (the scan begins inside the context, or noise alone makes the surface); mm to the lens's middle, NONE where
// there is no context before the focus.
#include "lib/Curvature.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D surface;
TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(rg32f, sightHit);                              // one pixel: hits on the line of sight to the focus's middle
uniform vec3 sightBase, sightDirection, focusMiddle;  // world, from the middle of the anchor plane, mm; where s = 0 on that line

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  vec2 hit = texelOf(hitPoints, pixel).xy;
  vec4 found = vec4(0.0, 0.0, 0.0, NONE);
  if (!isNone(hit.x) && (isNone(hit.y) || hit.x < hit.y - contextMargin)) {
    Ray ray = pixelRay(pixel);
    float sight = texelOf(sightHit, ivec2(0)).x;
    vec3 middle = isNone(sight) ? focusMiddle : sightBase + sight * sightDirection;
    found.w = length(worldPosition(ray, hit.x) - middle);
    if (hit.x > ray.sIn + contextMargin) {
      LevelSet context = levelSetAt(cellPosition(ray, hit.x));
      if (context.noise == 0.0) found.xyz = normalize(context.gradient) * rays.worldFromView;
    }
  }
  imageStore(surface, pixel, found);
}
