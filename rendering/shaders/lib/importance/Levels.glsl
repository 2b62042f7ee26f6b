// Rays are also opened to labels of other levels of importance than the focus's (rendering/scene/Importance.h; the interface is
// described in One.glsl): the surface may be that of a label that has nothing to do with the focus, and what is removed may be a
// less important label in focus.

const uint MAY_START_ON_FOCUS = 1u;

float ontoFocus(float field, vec2 range) {
  float on = clamp(field, range.x, range.y);
  const float ROUNDING = 1e-3;  // of an indicator of 0 to 1
  return abs(on - field) <= ROUNDING ? on : field;
}
