// An opening: rays start where stage 4 says, on the face that it cut into the volume, or on a surface (the interface is
// described in Closed.glsl).
#include <hole>
#include <light>
#include <schedule>
#include "lib/PixelRay.glsl"
#include "lib/opening/CutFace.glsl"

// Not as images, of which a shader may have eight: they are read once a ray.
uniform sampler2D rayStart, hitPoints;
uniform sampler2D pixelStarts;  // of the rays through the centres of pixels, where rays are SCATTERED

const bool ONLY_FOCUS = false;

float startAtCentre(ivec2 pixel) {
  return SCATTERED ? texelFetch(pixelStarts, pixel, 0).r : texelFetch(rayStart, pixel, 0).r;
}

// Normal of the cut face at a pixel, from the ray starts of the pixels beside it; zero where the ray does not start on a cut face.
vec3 wallNormal(ivec2 pixel, float start, vec2 hit) {
  // With APART, a ray may start on a face in front of the focus.
  bool hasNone = APART ? start == hit.y : !isNone(hit.y);
  if (hasNone || start <= hit.x + 0.5 * integral.cutFaceDepth) return vec3(0.0);
  ivec2 here = ivec2(placeOf(pixel));
  vec3 tangent[2];
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = ivec2(1 - axis, axis);
    ivec2 a = max(here - step, ivec2(0)), b = min(here + step, rays.pictureSize - 1);
    float sa = startAtCentre(a), sb = startAtCentre(b);
    if (isNone(sa) || isNone(sb)) return vec3(0.0);
    tangent[axis] = worldPosition(rayThrough(vec2(b) + 0.5), sb) - worldPosition(rayThrough(vec2(a) + 0.5), sa);
  }
  vec3 n = cross(tangent[0], tangent[1]);
  float size = length(n);
  return size > 0.0 ? n / size : vec3(0.0);
}

Cut cutAt(ivec2 pixel, Ray ray) {
  Cut cut = Cut(texelFetch(rayStart, pixel, 0).r, 0u, 0.0, vec2(0.0));
  if (isNone(cut.start)) return cut;
  vec2 hit = texelFetch(hitPoints, pixel, 0).xy;
  cut.onFocus = cut.start == hit.y ? 1u : 0u;
  if (LIT) {
    vec3 wall = wallNormal(pixel, cut.start, hit);
    if (dot(wall, wall) > 0.0) cut.share = integral.cutFaceShare;
    cut.light = lightOf(wall, ray.world);
  }
  lightByCap(cut, ray);
  return cut;
}

bool startsHere(Cut cut, Ray ray) { return !isNone(cut.start); }
bool startsGrey(Cut cut, Ray ray) { return startsGrey(cut, ray, cut.start); }
