// Stage 6: curvature, illumination and value of the context's first surface, inside the focus projection.
// Output: κ1, κ2 (1/mm), illumination, stored value, and the silhouette term 1 - |n·v| beside them; NONE in the first
// component where there is no such surface: the scan begins inside it, or the focus lies bare. Beside the scan's faces
// curvatures and silhouette fade: they would be those of what the spline takes for the values behind a face.
#include <volume>
#include "lib/Curvature.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"
#include "lib/light/BlinnPhong.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D contextLayer;
layout(r32f) uniform writeonly image2D silhouette;
TEXELS_2D(rg32f, hitPoints);

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  vec2 hit = texelOf(hitPoints, pixel).xy;
  vec4 layer = vec4(NONE, NONE, 0.0, 0.0);
  float rim = 0.0;
  if (!isNone(hit.y)) {
    Ray ray = pixelRay(pixel);
    if (hit.x > ray.sIn + contextMargin && hit.x < hit.y - contextMargin) {
      vec3 position = cellPosition(ray, hit.x);
      LevelSet surface = levelSetAt(position);
      if (surface.noise == 0.0) {
        vec3 normal = normalize(surface.gradient);
        float illumination = lighting.ambient + lighting.diffuse * abs(dot(normal, lighting.direction));
        layer = vec4(surface.within * vec2(surface.k1, surface.k2), illumination, storedExact(position));
        rim = surface.within * (1.0 - abs(dot(normal, ray.world)));
      }
    }
  }
  imageStore(contextLayer, pixel, layer);
  imageStore(silhouette, pixel, vec4(rim));
}
