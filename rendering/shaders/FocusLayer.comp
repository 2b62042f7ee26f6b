// Stage 5: emission–absorption integral from the ray start to the exit of the box, front to back.
// Output: premultiplied RGBA.
#include "lib/Region.glsl"
#include "lib/Ray.glsl"
#include "lib/Volume.glsl"
#include "lib/Crossing.glsl"
#include "lib/FocusIndex.glsl"
#include "lib/Lighting.glsl"
#include "lib/Classification.glsl"

#if LISTED
#include "lib/PixelList.glsl"
#else
uniform int pitch;  // pixels from one ray to the next
#endif

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform writeonly image2D focusLayer;

// Chebyshev distance in bricks to the nearest one that shows anything.
layout(r8ui) uniform readonly uimage3D occupiedSkip;
uniform float leastTransmittance;  // what is behind that little of it does not show

#if HAS_RAY_START
layout(r32f) uniform readonly image2D rayStart;
uniform sampler2D hitPoints;
#endif

// Where a ray starts: perhaps on the face that the opening cut into the volume, or on the focus's surface.
struct Cut {
  bool exists;
  float start;   // mm along the ray
  vec2 light;
  bool onFocus;  // whichever side of the surface rounding has put it on
};

#if SHADING
#include "lib/VolumeLight.glsl"
#endif

// A cut face is lit as the face it is; what lies under it, by its own gradient.
vec2 behindCut(vec2 light, Cut cut, float s) {
#if SHADING && HAS_RAY_START
  if (cut.exists) return mix(light, cut.light, wallShare * exp((cut.start - s) / wallDepth));
#endif
  return light;
}

#if CELL_BY_CELL
#include "lib/CellByCell.glsl"
#elif EVEN_STEPS
#include "lib/EvenSteps.glsl"
#else
#include "lib/FaceToFace.glsl"
#endif

void main() {
#if LISTED
  ivec2 pixel = listedPixel();
#else
  ivec2 pixel = pitch * regionPixel();
#endif
  if (any(greaterThanEqual(pixel, pictureSize))) return;
  Ray ray = pixelRay(pixel);
  vec4 result = vec4(0.0);
#if HAS_RAY_START
  float start = imageLoad(rayStart, pixel).r;
  bool visible = !isNone(start);
#else
  float start = ray.sIn;
  bool visible = ray.sIn <= ray.sOut;
#endif
  if (visible) {
    Cut cut = Cut(false, start, vec2(0.0), false);
#if HAS_RAY_START
    cut.onFocus = start == texelFetch(hitPoints, pixel, 0).y;
#endif
#if SHADING && HAS_RAY_START
    vec3 wall = wallNormal(pixel, start);
    cut.exists = dot(wall, wall) > 0.0;
    cut.light = lightOf(wall, ray.world);
#endif
    result = integrate(ray, start, cut);
  }
  imageStore(focusLayer, pixel, result);
}
