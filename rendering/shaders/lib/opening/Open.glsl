// An opening: rays start where stage 4 says, on the face that it cut into the volume, or on a surface (the interface is
// described in Closed.glsl).
#include <light>
#include <schedule>
#include "lib/PixelRay.glsl"
#include "lib/opening/CutFace.glsl"

// Not as images, of which a shader may have eight: they are read once a ray.
uniform sampler2D rayStart, hitPoints;
#if SCATTERED
uniform sampler2D pixelStarts;  // of the rays through the centres of pixels
#else
#define pixelStarts rayStart
#endif

const bool ONLY_FOCUS = false;

// Normal of the cut face at a pixel, from the ray starts of the pixels beside it; zero where the ray does not start on a cut face.
vec3 wallNormal(ivec2 pixel, float start, vec2 hit) {
#if APART
  // A ray may start on a face in front of the focus.
  bool hasNone = start == hit.y;
#else
  bool hasNone = !isNone(hit.y);
#endif
  if (hasNone || start <= hit.x + 0.5 * integral.cutFaceDepth) return vec3(0.0);
  ivec2 here = ivec2(placeOf(pixel));
  vec3 tangent[2];
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = ivec2(1 - axis, axis);
    ivec2 a = max(here - step, ivec2(0)), b = min(here + step, rays.pictureSize - 1);
    float sa = texelFetch(pixelStarts, a, 0).r, sb = texelFetch(pixelStarts, b, 0).r;
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
#if CLIPPED
  lightByCap(cut, ray);
#endif
  return cut;
}

bool startsHere(Cut cut, Ray ray) { return !isNone(cut.start); }

#if APART
// Of an opening that another camera cuts: from where to where a ray sees nothing again (RemovedParts.comp).
uniform sampler2D hole;

vec2 holeAt(ivec2 pixel) { return texelFetch(hole, pixel, 0).xy; }

Cut behindHole(Cut cut, ivec2 pixel, float end) {
  return Cut(end, end == texelFetch(hitPoints, pixel, 0).y ? 1u : 0u, 0.0, vec2(0.0));
}
#endif
