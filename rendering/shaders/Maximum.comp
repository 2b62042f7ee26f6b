// The greatest value of the context along each ray, beneath the focus layer (rendering/passes/MaximumPass.h). Output:
// premultiplied RGBA.
#include <begins>
#include <focus>
#include <translucent>
#include <schedule>
#include <volume>
#include "lib/Crossing.glsl"
#include "lib/FocusSides.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"
#include "lib/Search.glsl"
#include "lib/TransferSegments.glsl"
#include "lib/Traversal.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D picture;
uniform sampler2D focusLayer;
uniform float thickness;           // mm
uniform float leastStretch;        // mm, up to which nothing shows
uniform float leastTransmittance;  // of the focus layer, below which nothing behind it shows

const float HAIR = 1e-5;  // of the way through a cell

// The greatest value found, stored, and the translucent label there.
struct Greatest {
  float value;
  int label;
};

// Takes in a part of a path that is context, of one label, where its values are not in a gap: the greatest value of the
// cubic, or the lower end of the gap that holds that, where the part comes down so far.
void take(inout Greatest best, vec4 stored, int label) {
  vec2 turns = turningPoints(stored);
  float first = bernstein(stored, turns.x), second = bernstein(stored, turns.y);
  float high = max(max(stored.x, stored.w), max(first, second)), low = min(min(stored.x, stored.w), min(first, second));
  vec2 gap = gapAround(label, high);
  float shown = gap.x < gap.y ? gap.x : high;
  bool better = shown >= low && shown > best.value;
  best.value = better ? shown : best.value;
  best.label = better ? label : best.label;
}

// Takes in the context between two faces of a cell. `onFocus`: the path starts on the focus's surface.
void takeCell(inout Greatest best, Ray ray, ivec3 cell, float s, float sNext, const bool onFocus) {
  vec3 a = clamp(cellPosition(ray, s) - vec3(cell), 0.0, 1.0);
  vec3 b = clamp(cellPosition(ray, sNext) - vec3(cell), 0.0, 1.0);
  float f[8];
  cellCorners(cell, f);
  vec4 stored = bernsteinAlong(f, a, b);
  // No value on the path is above the hull of its coefficients.
  if (max(max(stored.x, stored.y), max(stored.z, stored.w)) <= best.value) return;
  FocusCell held = focusCellAt(focusSlot(cell), cell);
  bool holds = HAS_FOCUS && mayHoldFocus(held);
  vec4 field = focusAlong(held, a, b, stored);
  vec2 range = focusRange();
  if (onFocus) field.x = clamp(field.x, range.x, range.y);
  uint labels = labelsIn(cell);
  // A cubic crosses the two ends of a range at most six times; labels change at three places. What begins at a change is
  // told a hair behind it, where rounding does not decide; where the field stays that near to an end, by where the path ends.
  int left = 10;
  float from = 0.0, to = 1.0;
  do {
    float behind = from > 0.0 ? min(from + HAIR, 1.0) : 0.0;
    to = labelsDiffer(labels) ? nextLabel(a, b, from) : 1.0;
    if (holds) to = min(max(to, behind), nextChange(field, behind));
    if (--left == 0) behind = to = 1.0;
    bool inFocus = holds && sideOf(bernstein(field, behind)) == 0.0;
    int label = labelsDiffer(labels) ? labelAt(vec3(cell) + mix(a, b, 0.5 * (from + to))) : int(labels);
    if (!inFocus) take(best, bernsteinBetween(stored, from, to), label);
    from = to;
  } while (to < 1.0);
}

// Takes in the context from one s to another.
void takeStretch(inout Greatest best, Ray ray, float s, float sEnd, bool onFocus) {
  if (!(s + leastStretch < sEnd)) return;
  ivec3 upwards = upwardsOf(ray), cell = cellAt(ray, s);
  bool goesOn = true;
  do {
    int empty = emptyAround(texelOf(contextSkip, cell >> BRICK_SHIFT).r, cell);
    Face face = faceBehind(blockAt(cell, upwards, empty), ray, upwards, s);
    if (empty == 0) takeCell(best, ray, cell, s, min(face.s, sEnd), onFocus);
    onFocus = false;
    s = face.s;
    cell = cellBehind(face, upwards);
    goesOn = s < sEnd && isInVolume(cell);
  } while (goesOn);
}

// Whether the value is the lower end of a gap, but for rounding. The function may end there in a step, and what shows lies
// below it.
bool beginsGap(Greatest best) {
  bool begins = false;
  for (int i = 0; i < gapCount; ++i) {
    float end = gaps[best.label * gapCount + i].x;
    begins = begins || abs(best.value - end) <= 1e-6 * abs(end);
  }
  return begins;
}

// Colour and opacity of a layer of that value, of its label.
vec4 colourOf(Greatest best) {
  float entry = entryOf(best.value);
  int near = segmentNear(0, entry);
  float rounding = roundingOf(near);
  Segment segment = segmentAt(segmentFrom(near, entry + (beginsGap(best) ? -rounding : rounding)));
  vec4 material = segment.material + segment.slope * (entry - segment.anchor);
  float opacity = opacityOf(best.label) * (1.0 - exp(-max(material.a, 0.0) * thickness));
  return vec4(max(material.rgb, 0.0) * opacity, opacity);
}

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, imageSize(picture)))) return;
  vec4 before = texelFetch(focusLayer, pixel, 0);
  Ray ray = pixelRay(pixel);
  Reach reach = reachOf(pixel, ray);
  Greatest best = Greatest(-FAR, 0);
  if (1.0 - before.a >= leastTransmittance && ray.sIn <= ray.sOut) {
    takeStretch(best, ray, reach.from, reach.to, reach.onFocus != 0u);
    takeStretch(best, ray, reach.again, ray.sOut, false);
  }
  vec4 behind = vec4(0.0);
  if (best.value > -FAR) behind = colourOf(best);
  imageStore(picture, pixel, before + (1.0 - before.a) * behind);
}
