// Bodies of translucent labels: what a ray meets of one label in one go (rendering/settings/LabelSettings.h has the formulas).
// BODIES is 1 where a label is translucent.
#include "lib/Uniforms.glsl"

const bool HAS_BODIES = BODIES == 1;
const int FOCUS_LABELS = 1024;  // labels in focus are numbered from there on; 0: a point is of no translucent label

struct Label {
  int number;
  float opacity;
};

struct Body {
  Label label;
  float clear;  // transmittance of the body so far, were it whole
  float end;    // mm along the ray: what it showed last
};

// The two bodies that a ray has met last.
struct Bodies {
  Body last, before;
};

Label noLabel() { return Label(0, 1.0); }
Body newBody(Label label, float s) { return Body(label, 1.0, s); }
Bodies noBodies() { return Bodies(newBody(noLabel(), 0.0), newBody(noLabel(), 0.0)); }

// A label shows from s on.
void meet(inout Bodies bodies, Label label, float s) {
  if (label.number != bodies.last.label.number) {
    Body again = bodies.before;
    bodies.before = bodies.last;
    bodies.last = again;
    if (label.number != again.label.number) bodies.last = newBody(label, s);
  }
  bodies.last.clear = mix(bodies.last.clear, 1.0, clamp((s - bodies.last.end) * integral.perGap, 0.0, 1.0));
  bodies.last.end = s;
}

// What would shine through the body met last, were it whole, as a share of what does.
float wholeShare(Bodies bodies) {
  Body body = bodies.last;
  return body.clear / max(1.0 - body.label.opacity * (1.0 - body.clear), 1e-6);
}

// What shows of a piece of the body met last, up to s. `piece`: of the body as if it were whole.
vec4 shownOf(inout Bodies bodies, vec4 piece, float s) {
  vec4 shown = piece * (bodies.last.label.opacity * wholeShare(bodies));
  bodies.last.clear *= 1.0 - piece.a;
  bodies.last.end = s;
  return shown;
}

// A piece from one s to another of what a label covers, or nothing translucent does, and what shows of it.
vec4 shownOf(inout Bodies bodies, Label label, vec4 piece, float from, float to) {
  if (label.number == 0 || !(piece.a > 0.0)) return piece;
  meet(bodies, label, from);
  return shownOf(bodies, piece, to);
}
