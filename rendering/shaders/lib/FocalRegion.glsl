// A region that shows as it is while the context around it fades (MethodStages::Fading::Region in
// rendering/scene/Method.h). Places are as worldPosition() of lib/Ray.glsl has them. No file is included here that others
// include: those would lack it where FADING is not 2.

struct FocalSettings {
  vec3 middle;
  float size;  // mm: radius, or half the side
  int isBox;
};
// Uniforms of their own, as those of lib/Fading.glsl.
uniform vec3 focalMiddle;
uniform float focalSize, focalPerFallOff;  // mm, 1/mm
uniform int focalIsBox;
FocalSettings focal = FocalSettings(focalMiddle, focalSize, focalIsBox);

// δ: mm outside of the region.
float outsideOf(vec3 place) {
  vec3 from = place - focal.middle;
  return focal.isBox != 0 ? length(max(abs(from) - focal.size, 0.0)) : max(length(from) - focal.size, 0.0);
}

// Where a straight path of `size` mm enters and leaves the region, the path 0 to 1; the first is greater where it passes
// by.
vec2 regionAlong(vec3 front, vec3 direction, float size) {
  vec3 from = front - focal.middle;
  // Of the sphere from the point of the line nearest to the middle, so that no difference of large squares is taken.
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
