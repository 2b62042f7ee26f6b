// The integral over a part of a context that fades (lib/Fading.glsl), within a bound on its error or without one.
#include <light>
#include <opening>
#include "lib/Crossing.glsl"
#include "lib/integral/FadingPiece.glsl"
#include "lib/integral/Section.glsl"
#include "lib/integral/Settings.glsl"
#if FADING
#ifndef ROUGH_STEPS
#define ROUGH_STEPS 0
#endif
const int MOST_STEPS = 128;  // through a part
// Of the bound: where the light falls to nothing, how much fades has a cusp, and errors fall more slowly than lengths.
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
  vec3 slope = bernstein(section.normals.slopes.along, along);
#if FADING == 3
  point.fade = fadeOfGhost(slope, ray.world);
#elif FADING == 2
  point.fade = fadeAround(length(slope), outsideOf(worldPosition(ray, s)));
#elif FADING == 4
  point.fade = fadeAround(length(slope), bernstein(section.normals.slopes.outside, along));
#else
  point.fade = fadeAt(length(slope), intensityOf(light), s);
#endif
  light = behindCut(light, cut, s);
  point.colour = material.rgb * light.x + light.y;
  return point;
}

// Where in a part, 0 to 1, the part enters and leaves what shows as it is, behind x: a focal region, or what lies between
// two ghosts. Of some shapes only the next of these; where nothing of it comes, the first is greater than 1.
vec2 wholeBehind(Section section, Ray ray, Part part, float x) {
  vec2 ends = mix(vec2(section.sFrom), vec2(section.sTo), vec2(part.from, part.to)), region = vec2(3e38, -3e38);
#if FADING == 3
  float size = max(ends.y - ends.x, 1e-6), s = mix(ends.x, ends.y, x), next = nextGhostEnd(s + 1e-6 * size, ends.y);
  float border = (next - ends.x) / size;
  region = isGhosted(0.5 * (s + next)) ? vec2(border, 3e38) : vec2(-3e38, border);
#elif FADING == 2
  region = regionAlong(worldPosition(ray, ends.x), ray.world, ends.y - ends.x);
  if (region.x > region.y) region = vec2(3e38, -3e38);
#elif FADING == 4
  vec4 outside = section.normals.slopes.outside;
  vec2 within = mix(vec2(section.uFrom), vec2(section.uTo), vec2(part.from, part.to));
  float extent = max(within.y - within.x, 1e-12), u = mix(within.x, within.y, x), next = nextSignChange(outside, u);
  // A crossing of which only the rounding lies behind x is that at which the step before ended.
  if (next - u < 1e-6 * extent) next = nextSignChange(outside, u + 1e-6 * extent);
  float border = (next - within.x) / extent;
  region = bernstein(outside, 0.5 * (u + next)) > 0.0 ? vec2(border, 3e38) : vec2(-3e38, border);
#endif
  return region;
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
#if !ROUGH_STEPS
    FadingPoint early = fadingPointAt(section, ray, cut, part, from + 0.25 * extent);
    FadingPoint late = fadingPointAt(section, ray, cut, part, from + 0.75 * extent);
    vec4 taken = pieceOf(front, early, middle, 0.5 * lengthOfStep, seen, fades);
    taken = over(taken, pieceOf(middle, late, back, 0.5 * lengthOfStep, seen * (1.0 - taken.a), fades));
    float wrong = highest(abs(whole - taken));
#else
    vec4 taken = whole;
#if FADING == 1
    float wrong = ROUGH_SHARE * highest(abs(whole - pieceOf(front, back, lengthOfStep, seen)));
#else
    const float wrong = 0.0;
#endif
#endif
    float shown = seen * taken.a;
    float excess = seen * wrong / (integral.maxError * max(max(shown, share * extent), LEAST_SHARE));
    if (excess <= 1.0 || left == 1) {
      result = over(result, taken);
      seen = transmittance * (1.0 - result.a);
      from = last ? stop : from + extent;
      front = back;
#if FADING > 2
      if (last) region = wholeBehind(section, ray, part, stop);
#endif
      if (last && stop < 1.0) stop = nextStop(section, part, region, stop);
    }
    // The estimate falls with the third power of the length at least.
    extent *= clamp(0.9 * pow(max(excess, 1e-6), -1.0 / 3.0), 0.2, 4.0);
  } while (--left > 0 && from < 1.0 && seen >= integral.leastTransmittance);
  return result;
}
#endif
