// The one ray set-up that every pass shares, so that every t stored for a pixel lies on the same ray. Positions along it
// are s = t - distance: the ray is anchored on a plane near the volume, which keeps float32 exact enough however far
// away the eye is. See rendering/gpu/RayFrame.h.
#include <schedule>
#include <clip>
#include <places>
#include "lib/Ray.glsl"
#include "lib/Uniforms.glsl"

// -1 … 1 across the picture, upwards.
vec2 deviceCoordinates(vec2 place) {
  vec2 ndc = 2.0 * place / vec2(rays.pictureSize) - 1.0;
  return vec2(ndc.x, -ndc.y);
}

// The ray's direction in the view's axes: from the eye to the anchor plane, mm; (0, 0, 1) where rays are parallel.
vec3 towardsAnchor(vec2 place) { return vec3(deviceCoordinates(place) * rays.spread, rays.depth); }

// Length of that vector less its depth, without cancellation.
float beyondPlane(vec3 towards, float along) { return dot(towards.xy, towards.xy) / (along + towards.z); }

// Inside the volume's box, whatever clips it.
Ray wholeRayThrough(vec2 place) {
  vec2 offset = deviceCoordinates(place) * rays.halfSize;
  vec3 towards = towardsAnchor(place);
  float along = length(towards), sAnchor = beyondPlane(towards, along);
  vec3 view = towards / along;
  Ray ray;
  ray.direction = rays.cellsFromView * view;
  ray.world = rays.worldFromView * view;
  ray.base = rays.anchor + rays.cellsFromView * vec3(offset, 0.0) - sAnchor * ray.direction;
  ray.worldBase = rays.worldFromView * vec3(offset, 0.0) - sAnchor * ray.world;
  clipTo(ray, vec3(0.5), vec3(volume.dims) + 0.5, -rays.distance);
  return ray;
}

Ray rayThrough(vec2 place) {
  Ray ray = wholeRayThrough(place);
  clipToHalfSpaces(ray);
  return ray;
}

Ray wholePixelRay(ivec2 pixel) { return wholeRayThrough(placeOf(pixel)); }
Ray pixelRay(ivec2 pixel) { return rayThrough(placeOf(pixel)); }

// View depth of s on the pixel's ray, mm behind the anchor plane.
float depthAtPosition(ivec2 pixel, float s) {
  vec3 towards = towardsAnchor(placeOf(pixel));
  float along = length(towards);
  return (s - beyondPlane(towards, along)) * (towards.z / along);
}

// Where the pixel's ray crosses the plane parallel to the picture `depth` mm behind the anchor plane.
float positionAtDepth(ivec2 pixel, float depth) {
  vec3 towards = towardsAnchor(placeOf(pixel));
  float along = length(towards);
  return depth * (along / towards.z) + beyondPlane(towards, along);
}
