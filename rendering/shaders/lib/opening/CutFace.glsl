// How a face that an opening or a clip plane cuts into the volume is lit (rendering/scene/Lighting.h).
#include <clip>
#include <light>
#include <volume>
#include "lib/Uniforms.glsl"

struct Cut {
  float start;    // mm along the ray
  uint onFocus;   // 1: the ray starts on the focus's surface, on whichever side rounding has put it
  float share;    // of the light just behind the cut that is the cut face's own; 0: there is no cut face
  vec2 light;     // of the cut face
};

// A cut face is lit as the face it is; the volume under it, by its own gradient.
vec2 behindCut(vec2 volumeLight, Cut cut, float s) {
  if (!LIT || cut.share == 0.0) return volumeLight;
  return mix(volumeLight, cut.light, cut.share * exp((cut.start - s) / integral.cutFaceDepth));
}

// A ray that enters by a capped face has its light, as far as it reaches behind the face.
void lightByCap(inout Cut cut, Ray ray) {
  if (!CLIPS || !LIT) return;
  bool byCap = cut.share == 0.0 && ray.cap >= 0;
  vec2 light = lightOf(capNormal(ray), ray.world);
  cut.light = byCap ? light : cut.light;
  cut.share = byCap ? integral.cutFaceShare * exp((ray.sIn - cut.start) / integral.cutFaceDepth) : cut.share;
}

// Whether a ray that sees the volume as it is from `opened` on starts on a capped face that shows grey; the focus shows as it
// is.
bool startsGrey(Cut cut, Ray ray, float opened) {
  return GREY_FACES && ray.cap >= 0 && cut.onFocus == 0u && opened <= ray.sIn + 0.5 * integral.cutFaceDepth;
}

vec4 greyOf(Ray ray) {
  float value = storedExact(cellPosition(ray, ray.sIn));
  return vec4(vec3(clamp(value * clipping.grey.x + clipping.grey.y, 0.0, 1.0)), 1.0);
}
