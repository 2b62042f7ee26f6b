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

// Of the rays that an invocation follows.
#define EACH for (int i = 0; i < RAYS; ++i)

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
#else
#include "lib/FaceToFace.glsl"
#endif

void main() {
  ivec2 pixels[RAYS];
  Ray rays[RAYS];
  float starts[RAYS];
  Cut cuts[RAYS];
  bool visible[RAYS];
  EACH {
#if LISTED
    pixels[i] = listedPixel(i);
#else
    pixels[i] = pitch * regionPixel(i);
#endif
    rays[i] = pixelRay(pixels[i]);
#if HAS_RAY_START
    starts[i] = imageLoad(rayStart, pixels[i]).r;
    visible[i] = !isNone(starts[i]);
#else
    starts[i] = rays[i].sIn;
    visible[i] = rays[i].sIn <= rays[i].sOut;
#endif
    visible[i] = visible[i] && all(lessThan(pixels[i], pictureSize));
    cuts[i] = Cut(false, starts[i], vec2(0.0), false);
#if HAS_RAY_START
    if (visible[i]) {
      cuts[i].onFocus = starts[i] == texelFetch(hitPoints, pixels[i], 0).y;
#if SHADING
      vec3 wall = wallNormal(pixels[i], starts[i]);
      cuts[i].exists = dot(wall, wall) > 0.0;
      cuts[i].light = lightOf(wall, rays[i].world);
#endif
    }
#endif
  }
  vec4 results[RAYS];
  integrate(rays, starts, cuts, visible, results);
#if !CELL_BY_CELL
  // Of what the light that is left might still have met, half is taken for there, in the colour so far.
  EACH if (1.0 - results[i].a < leastTransmittance) results[i] *= 0.5 + 0.5 / results[i].a;
#endif
  EACH imageStore(focusLayer, pixels[i], results[i]);
}
