// The one ray set-up that every pass shares, so that every t stored for a pixel lies on the same ray. Positions along it
// are s = t - distance: the ray is anchored on a plane near the volume, which keeps float32 exact enough however far
// away the eye is. See rendering/gpu/RayFrame.h.
#include <schedule>
#include "lib/Grid.glsl"
#include "lib/Ray.glsl"

struct RaySettings {
  mat3 cellsFromView;  // cells per mm along the view's right, up and forward
  mat3 worldFromView;  // columns: right, up, forward as unit vectors in world space
  vec3 anchor;         // cell frame: where the view axis meets the anchor plane
  float distance;      // mm from the eye (or the plane through it) to the anchor plane
  vec2 halfSize;       // mm on the anchor plane at the picture's right and top edge
  ivec2 pictureSize;
  uint perspective;
};
UNIFORM_BLOCK(RayBlock, storedRays, RaySettings, rays);

// mm on the anchor plane, from its middle to where the pixel's ray meets it.
vec2 offsetOf(ivec2 pixel) {
  vec2 ndc = 2.0 * (vec2(pixel) + 0.5) / vec2(rays.pictureSize) - 1.0;
  return vec2(ndc.x, -ndc.y) * rays.halfSize;
}

Ray pixelRay(ivec2 pixel) {
  vec2 offset = offsetOf(pixel);
  vec3 view = vec3(0.0, 0.0, 1.0);
  float sAnchor = 0.0;
  if (rays.perspective != 0u) {
    float along = length(vec3(offset, rays.distance));
    view = vec3(offset, rays.distance) / along;
    sAnchor = dot(offset, offset) / (along + rays.distance);  // = along - distance, without cancellation
  }
  Ray ray;
  ray.direction = rays.cellsFromView * view;
  ray.world = rays.worldFromView * view;
  ray.base = rays.anchor + rays.cellsFromView * vec3(offset, 0.0) - sAnchor * ray.direction;
  ray.worldBase = rays.worldFromView * vec3(offset, 0.0) - sAnchor * ray.world;
  clipTo(ray, vec3(0.5), vec3(volume.dims) + 0.5, -rays.distance);
  return ray;
}

// Where the pixel's ray crosses the plane parallel to the picture `depth` mm behind the anchor plane.
float positionAtDepth(ivec2 pixel, float depth) {
  if (rays.perspective == 0u) return depth;
  vec2 offset = offsetOf(pixel);
  float along = length(vec3(offset, rays.distance));
  return depth * (along / rays.distance) + dot(offset, offset) / (along + rays.distance);
}
