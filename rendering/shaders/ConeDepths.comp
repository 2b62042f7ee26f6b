// Cones, first step: the depth of each pixel that a cone stands on, the pyramid's level 0.
#include "lib/Cones.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rg32f, hitPoints);

bool isInPicture(ivec2 pixel) {
  return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, rays.pictureSize));
}

bool isBesideFocus(ivec2 pixel) { return isInPicture(pixel) && isNone(texelOf(hitPoints, pixel).y); }

// With SILHOUETTE, cones stand on the silhouette of the focus's projection alone.
bool hasCone(ivec2 pixel) {
  return SILHOUETTE == 0 || isBesideFocus(pixel + ivec2(1, 0)) || isBesideFocus(pixel - ivec2(1, 0)) ||
         isBesideFocus(pixel + ivec2(0, 1)) || isBesideFocus(pixel - ivec2(0, 1));
}

void main() {
  ivec2 at = regionPixel();
  ivec2 size = cones.tops << CONE_TOP;
  if (any(greaterThanEqual(at, size))) return;
  ivec2 pixel = cones.origin + at;
  float depth = -FAR;
  if (isInPicture(pixel)) {
    float s = texelOf(hitPoints, pixel).y;
    if (!isNone(s) && hasCone(pixel)) depth = depthAtPosition(pixel, s);
  }
  coneDepths[coneLevel(CONE_TOP) + at.y * size.x + at.x] = depth;
}
