// The integral over a part of a context that fades (`<fading>`), within a bound on its error or, with ROUGH_STEPS, without one.
#include <fading>
#include <light>
#include <opening>
#include "lib/Crossing.glsl"
#include "lib/integral/FadingPiece.glsl"
#include "lib/integral/Section.glsl"
#include "lib/integral/Settings.glsl"

const int MOST_STEPS = 128;  // through a part
// The least share of the bound that a step is allowed: where the light falls to nothing, how much fades has a cusp, and errors
// fall more slowly than lengths.
const float LEAST_SHARE = 0.001;
// How wrong a step through its middle is taken to be, as a share of the difference to a step from both ends alone. RMS
// errors in 1/255 on a torso CT and a CT head: 0.22 and 0.11 with 0.1, at 1.4 times the time; 0.51 and 0.29 with 0.02; 1.4
// and 0.45 with 0.005.
const float ROUGH_SHARE = 0.02;

FadingPoint fadingPointAt(Section section, Ray ray, Cut cut, Part part, float x) {
  Segment segment = part.segment;
  float entry = clamp(bernstein(part.entries, x), segment.low, segment.high) - segment.anchor;
  vec4 material = segment.material + segment.slope * entry;
  float within = mix(part.from, part.to, x), along = mix(section.uFrom, section.uTo, within);
  float s = mix(section.sFrom, section.sTo, within);
  vec2 light = lightAlong(section.normals, along, ray.world, false);
  FadingPoint point;
  point.extinction = max(material.a, 0.0);
  point.fade = fadeOf(section.normals.slopes, along, ray, s, light);
  light = behindCut(light, cut, s);
  point.colour = material.rgb * light.x + light.y;
  return point;
}

// Where a part, 0 to 1, enters and leaves what shows as it is, behind x; see wholeBehind() of `<fading>`.
vec2 wholeBehind(Section section, Ray ray, Part part, float x) {
  vec2 ends = mix(vec2(section.sFrom), vec2(section.sTo), vec2(part.from, part.to));
  vec2 within = mix(vec2(section.uFrom), vec2(section.uTo), vec2(part.from, part.to));
  return wholeBehind(section.normals.slopes, within, ray, ends, x);
}

// Where in a part, 0 to 1, the next step has to end at the latest. `region`: where the part enters and leaves what shows
// as it is.
float nextStop(Section section, Part part, vec2 region, float x) {
  vec2 ends = mix(vec2(section.uFrom), vec2(section.uTo), vec2(part.from, part.to));
  float turn = nextTurn(section.normals, mix(ends.x, ends.y, x));
  float stop = turn < ends.y ? max((turn - ends.x) / (ends.y - ends.x), x + 1e-6) : 1.0;
  float border = region.x > x + 1e-6 ? region.x : region.y > x + 1e-6 ? region.y : 1.0;
  return min(stop, border);
}

// Whether the context fades, 1, or the middle of a step shows as it is, 0.
float fadesBetween(vec2 region, float from, float to) {
  float middle = 0.5 * (from + to);
  return region.x <= middle && middle <= region.y ? 0.0 : 1.0;
}

// A part of the context that fades, step by step. A step's error is estimated by what two of half its length change; the
// steps' allowed errors are as integratePart() has the parts'. `transmittance` and `share` as there. ROUGH_STEPS: a step
// has no halves. Where what lies before a point decides, its error is then guessed; elsewhere it is taken to be small.
vec4 integrateFading(Section section, Ray ray, Cut cut, Part part, float transmittance, float share) {
  float size = (part.to - part.from) * (section.sTo - section.sFrom), from = 0.0, extent = 1.0, seen = transmittance;
  vec2 region = wholeBehind(section, ray, part, 0.0);
  float stop = nextStop(section, part, region, 0.0);
  vec4 result = vec4(0.0);
  FadingPoint front = fadingPointAt(section, ray, cut, part, 0.0);
  int left = MOST_STEPS;
  do {
    stop = left == 1 ? 1.0 : stop;
    bool last = extent >= stop - from || left == 1;
    if (last) extent = stop - from;
    FadingPoint middle = fadingPointAt(section, ray, cut, part, from + 0.5 * extent);
    FadingPoint back = fadingPointAt(section, ray, cut, part, last ? stop : from + extent);
    float lengthOfStep = extent * size, fades = fadesBetween(region, from, from + extent);
    vec4 whole = pieceOf(front, middle, back, lengthOfStep, seen, fades);
    vec4 taken = whole;
    float wrong = 0.0;
    if (ROUGH_STEPS == 0) {
      FadingPoint early = fadingPointAt(section, ray, cut, part, from + 0.25 * extent);
      FadingPoint late = fadingPointAt(section, ray, cut, part, from + 0.75 * extent);
      taken = pieceOf(front, early, middle, 0.5 * lengthOfStep, seen, fades);
      taken = over(taken, pieceOf(middle, late, back, 0.5 * lengthOfStep, seen * (1.0 - taken.a), fades));
      wrong = highest(abs(whole - taken));
    } else if (FOLLOWS_LIGHT) {
      wrong = ROUGH_SHARE * highest(abs(whole - pieceOf(front, back, lengthOfStep, seen)));
    }
    float shown = seen * taken.a;
    float excess = seen * wrong / (integral.maxError * max(max(shown, share * extent), LEAST_SHARE));
    if (excess <= 1.0 || left == 1) {
      result = over(result, taken);
      seen = transmittance * (1.0 - result.a);
      from = last ? stop : from + extent;
      front = back;
      if (BORDERS_IN_TURN && last) region = wholeBehind(section, ray, part, stop);
      if (last && stop < 1.0) stop = nextStop(section, part, region, stop);
    }
    // The estimate falls with the third power of the length at least.
    extent *= clamp(0.9 * pow(max(excess, 1e-6), -1.0 / 3.0), 0.2, 4.0);
  } while (--left > 0 && from < 1.0 && seen >= integral.leastTransmittance);
  return result;
}
