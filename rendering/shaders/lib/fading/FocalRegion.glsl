// A sphere or a box shows as it is while the context around it fades (the interface is described in None.glsl). Places are as
// worldPosition() of lib/Ray.glsl has them.
#include "lib/Crossing.glsl"
#include "lib/fading/Focal.glsl"

struct FocalSettings {
  vec3 middle;
  float size;
  int isBox;
};
uniform vec3 focalMiddle;
uniform int focalIsBox;
FocalSettings focal = FocalSettings(focalMiddle, focalSize, focalIsBox);

const bool BORDERS_IN_TURN = false;

vec4 outsideAlong(ivec3 cell, vec3 a, vec3 b) { return vec4(0.0); }

// δ: mm outside of the region.
float outsideOf(vec3 place) {
  vec3 from = place - focal.middle;
  return focal.isBox != 0 ? length(max(abs(from) - focal.size, 0.0)) : max(length(from) - focal.size, 0.0);
}

// Where a straight path of `size` mm enters and leaves the region, the path 0 to 1; the first is greater where it passes
// by.
vec2 regionAlong(vec3 front, vec3 direction, float size) {
  vec3 from = front - focal.middle;
  // A sphere is met around the point of the line nearest to its middle, so that no difference of large squares is taken.
  float nearest = -dot(from, direction);
  vec3 across = from + nearest * direction;
  float square = focal.size * focal.size - dot(across, across), reach = sqrt(max(square, 0.0));
  vec2 round = square > 0.0 ? vec2(nearest - reach, nearest + reach) : vec2(3e38, -3e38);
  vec3 steep = mix(direction, vec3(1e-9), lessThan(abs(direction), vec3(1e-9)));
  vec3 low = (-focal.size - from) / steep, high = (focal.size - from) / steep;
  vec3 first = min(low, high), last = max(low, high);
  vec2 faced = vec2(max(first.x, max(first.y, first.z)), min(last.x, min(last.y, last.z)));
  return (focal.isBox != 0 ? faced : round) / max(size, 1e-6);
}

float fadeOf(Slopes slopes, float along, Ray ray, float s, vec2 light) {
  vec3 slope = bernstein(slopes.along, along);
  return fadeAround(length(slope), outsideOf(worldPosition(ray, s)));
}

vec2 wholeBehind(Slopes slopes, vec2 within, Ray ray, vec2 ends, float x) {
  vec2 region = regionAlong(worldPosition(ray, ends.x), ray.world, ends.y - ends.x);
  if (region.x > region.y) region = vec2(3e38, -3e38);
  return region;
}
