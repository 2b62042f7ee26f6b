// The volume rendering integral along a path through a cell, within a bound on its error.
//
// The values along the path are a cubic. The cubic is cut where it meets the nodes of the transfer function. Over a part
// between two cuts colour and extinction are linear in the value, so the part's optical depth is exact. Left to approximate
// is the mean of colour and light over the part, weighted by what is seen of it: it is taken to second order in the
// position, from the weight's mean and variance. Its error is estimated beforehand and falls at least as 1/n² with n
// pieces; a part is cut into as many as the bound asks for.
#include <fading>
#include <focus>
#include <light>
#include <occlusion>
#include <opening>
#include <schedule>
#include "lib/TransferSegments.glsl"
#include "lib/Traversal.glsl"
#include "lib/integral/FadingPart.glsl"
#include "lib/integral/Piece.glsl"
#include "lib/integral/Section.glsl"
#include "lib/integral/Settings.glsl"

const int MOST_PIECES = 64;  // of a part
const int MOST_PARTS = 256;  // of a cell

// Stages of a walk; SECTIONS: of a cell some of which may be in the focus, or of a translucent label.
const int LEAP = 0, LOOK = 1, CONTEXT = 2, SECTIONS = 3, ENDED = 4;

// What a part holds, whatever light falls on it. Positions are 0 to 1 from its front; the weight of a position is the
// light emitted there that gets out of the part's front.
struct Medium {
  float depth;             // optical
  float growth;            // of the extinction from front to back, over its mean: -2 to 2
  float steepness;         // greatest change of the extinction over its mean, 4 at most
  vec2 change;             // of the entries from front to back, and of what bends away from that to the middle, times 4
  float centre, variance;  // of the positions by their weights
  vec3 colour;             // of what is seen
};

Medium mediumOf(Part part, float size) {
  Segment segment = part.segment;
  vec4 e = part.entries;
  float mean = clamp(0.25 * (e.x + e.y + e.z + e.w), segment.low, segment.high);
  Medium medium;
  // The best line's slope is 12 times the first moment of the cubic; the rest is nearly q (u² - u + 1/6).
  medium.change = vec2(0.3 * (3.0 * (e.w - e.x) + e.z - e.y), 1.5 * (e.x - e.y - e.z + e.w));
  float extinction = max(segment.material.a + segment.slope.a * (mean - segment.anchor), 0.0);
  medium.depth = extinction * size;
  float slope = segment.slope.a / max(extinction, 1e-30);
  medium.growth = clamp(slope * medium.change.x, -2.0, 2.0);
  medium.steepness = min(abs(slope) * (abs(medium.change.x) + abs(medium.change.y)), 4.0);
  vec2 moments = momentsOfEmission(medium.depth, medium.growth);
  medium.centre = moments.x;
  medium.variance = moments.y;
  float seen = clamp(mean + medium.change.x * (medium.centre - 0.5), segment.low, segment.high);
  medium.colour = segment.material.rgb + segment.slope.rgb * (seen - segment.anchor);
  return medium;
}

// By how much the centre may be wrong. For small depths the next term of its series; the greatest error for any depth is
// 0.1, in a deep part whose extinction begins at 0.
float centreError(Medium medium) {
  return min(medium.depth * medium.growth * medium.growth * (1.0 / 240.0), 0.1);
}

// Estimated error of the colour, of the worst channel.
float colourError(Medium medium, Segment segment) {
  float slope = highest(vec4(abs(segment.slope.rgb), 0.0)), steep = medium.steepness, depth = medium.depth;
  float bent = min((depth * depth + 2.0 * depth * steep) * (1.0 / 360.0), 1.0 / 6.0) + steep * (1.0 / 180.0);
  return slope * (abs(medium.change.x) * centreError(medium) + abs(medium.change.y) * bent);
}

// The light at the front, in the middle and at the back of a part.
struct Lights {
  vec2 front, middle, back;
  vec2 openFront, openMiddle, openBack;  // shares of ambient and of direct light that arrive there
};

vec2 lightIn(Section section, Ray ray, Cut cut, float x) {
  vec2 light = lightAlong(section.normals, mix(section.uFrom, section.uTo, x), ray.world, section.inFocus);
  return behindCut(light, cut, mix(section.sFrom, section.sTo, x));
}

vec2 openIn(Section section, Ray ray, float x) { return openAt(cellPosition(ray, mix(section.sFrom, section.sTo, x))); }

// The light at a part's middle and back, behind that of a part before it.
void lightPart(inout Lights lights, Section section, Ray ray, Cut cut, float from, float to) {
  lights.middle = lightIn(section, ray, cut, 0.5 * (from + to));
  lights.back = lightIn(section, ray, cut, to);
  if (OCCLUDES) {
    lights.openMiddle = openIn(section, ray, 0.5 * (from + to));
    lights.openBack = openIn(section, ray, to);
    lights.middle = occluded(lights.middle, lights.openMiddle);
    lights.back = occluded(lights.back, lights.openBack);
  }
}

Lights lightsOf(Section section, Ray ray, Cut cut, float from, float to) {
  Lights lights;
  lights.front = lightIn(section, ray, cut, from);
  if (OCCLUDES) {
    lights.openFront = openIn(section, ray, from);
    lights.front = occluded(lights.front, lights.openFront);
  }
  lightPart(lights, section, ray, cut, from, to);
  return lights;
}

// Estimated error of the light. A parabola through three points is right to 1/30 of its bend where the light's slope has
// no jump; piecesOfLight() sees to the jumps.
//
// Where weights fall off with the depth, more of the bend counts, and so does depth/120 of a cubic u (u - 1/2) (u - 1),
// which three points cannot show: it is taken for a third of the change from end to end.
float lightError(Medium medium, Lights lights) {
  vec2 turn = abs(lights.back - lights.front), bend = abs(lights.front - 2.0 * lights.middle + lights.back);
  float depth = min(medium.depth, 4.0), uneven = medium.steepness + depth * (1.0 + abs(medium.growth));
  return (bend.x + bend.y) * (1.0 / 30.0 + uneven * (1.0 / 90.0)) + (turn.x + turn.y) * depth * (1.0 / 360.0) +
         (turn.x + turn.y + bend.x + bend.y) * centreError(medium);
}

vec4 pieceOf(Medium medium, Segment segment, Lights lights) {
  float x = medium.centre, square = medium.variance + x * x;
  vec2 light = lights.front * (1.0 - 3.0 * x + 2.0 * square) + lights.middle * (4.0 * (x - square)) +
               lights.back * (2.0 * square - x);
  vec3 together = segment.slope.rgb * (medium.change.x * (lights.back.x - lights.front.x) * medium.variance);
  return vec4(max(medium.colour * light.x + together + light.y, 0.0), 1.0)
         * (medium.depth * relativeOpacity(medium.depth));
}

// `transmittance`: in front of the part; `share`: its share of the ray's length.
vec4 integratePart(Section section, Ray ray, Cut cut, Part part, float transmittance, float share) {
  if (FADES) {
    vec2 ends = mix(vec2(section.sFrom), vec2(section.sTo), vec2(part.from, part.to));
    if (!section.inFocus && mayFade(ends)) return integrateFading(section, ray, cut, part, transmittance, share);
  }
  float size = (part.to - part.from) * (section.sTo - section.sFrom);
  Medium medium = mediumOf(part, size);
  Lights lights = lightsOf(section, ray, cut, part.from, part.to);
  vec4 result = pieceOf(medium, part.segment, lights);
  // A part's allowed error is its share of the bound, by its opacity or by its length: each sums to at most 1 over the ray.
  float shown = transmittance * result.a, weight = shown / (integral.maxError * max(shown, share));
  vec2 ends = mix(vec2(section.uFrom), vec2(section.uTo), vec2(part.from, part.to));
  float ofOpen = openError(lights.openFront, lights.openMiddle, lights.openBack);
  float pieces = max(sqrt(weight * (colourError(medium, part.segment) + lightError(medium, lights) + ofOpen)),
                     piecesOfLight(section.normals, ends.x, ends.y, section.inFocus, ray.world, weight));
  if (pieces > 1.0) {
    int count = int(ceil(min(pieces, float(MOST_PIECES)))), i = 0;
    result = vec4(0.0);
    do {
      vec2 u = vec2(i, i + 1) / float(count);
      Part piece = partBetween(part, u.x, u.y);
      lightPart(lights, section, ray, cut, piece.from, piece.to);
      result = over(result, pieceOf(mediumOf(piece, size / float(count)), part.segment, lights));
      lights.front = lights.back;
    } while (++i < count);
  }
  return result;
}

bool shows(Part part) { return part.segment.material.a > 0.0 || part.segment.slope.a != 0.0; }

// The part of a section from `from` to the next node, or to the section's end. `index`: its segment; that of the part
// behind it afterwards.
Part nextPart(Section section, float from, inout int index) {
  Part part;
  part.segment = segmentAt(index);
  part.from = from;
  part.to = 1.0;
  part.entries = bernsteinBetween(section.entries, from, 1.0);
  float low = part.segment.low, high = part.segment.high;
  if (leavesHull(part.entries, low, high) && !isEven(part.entries, roundingOf(index))) {
    // The front lies on the node where the part before ended: from there inwards.
    float hair = min(0.01, 0.25 * (high - low));
    part.entries.x = clamp(part.entries.x, low + hair, high - hair);
    float end = firstExit(part.entries, low, high);
    if (end < 1.0) {
      index += bernstein(part.entries, end) < 0.5 * low + 0.5 * high ? -1 : 1;
      part.entries = bernsteinBetween(part.entries, 0.0, end);
      part.to = mix(from, 1.0, end);
    }
  }
  return part;
}

// What shows of a part of a section: of a translucent label, what shows of its body.
vec4 showPart(Section section, Ray ray, Cut cut, Part part, float transmittance, float share, inout Bodies bodies) {
  if (!HAS_BODIES || section.label.number == 0) return integratePart(section, ray, cut, part, transmittance, share);
  vec2 ends = mix(vec2(section.sFrom), vec2(section.sTo), vec2(part.from, part.to));
  meet(bodies, section.label, ends.x);
  return shownOf(bodies, integratePart(section, ray, cut, part, transmittance * wholeShare(bodies), share), ends.y);
}

// `transmittance`: in front of the section; `share`: its share of the ray's length.
vec4 integrateSection(Section section, Ray ray, Cut cut, float transmittance, float share, inout Bodies bodies) {
  if (!isByValue(section)) {
    Segment segment =
        constantSegment(vec4(section.material.rgb / max(section.material.a, 1e-30), section.material.a));
    return showPart(section, ray, cut, Part(0.0, 1.0, vec4(0.0), segment), transmittance, share, bodies);
  }
  vec4 result = vec4(0.0);
  int index = segmentOf(functionOf(section), section.entries), left = MOST_PARTS;
  float from = 0.0;
  do {
    Part part = nextPart(section, from, index);
    if (--left == 0) part.to = 1.0;
    if (shows(part))
      result = over(result, showPart(section, ray, cut, part, transmittance * (1.0 - result.a),
                                     share * (part.to - part.from), bodies));
    from = part.to;
  } while (from < 1.0);
  return result;
}

Section wholeOf(CellPath path, CellNormals normals) {
  Section section;
  section.uFrom = 0.0;
  section.uTo = 1.0;
  section.sFrom = path.sFrom;
  section.sTo = path.sTo;
  section.entries = path.entries;
  section.inFocus = false;
  section.material = vec4(0.0);
  section.function = 0;
  section.label = noLabel();
  section.normals = normals;
  return section;
}

// A cell that holds both focus and context, or translucent labels, section by section.
vec4 integrateSections(CellPath path, CellNormals normals, Ray ray, Cut cut, float transmittance, float share,
                       inout Bodies bodies) {
  Section section = wholeOf(path, normals);
  if (OWN_NORMALS) focusNormalsAlong(path.cell, path.a, path.b, section.normals.focus);
  vec4 result = vec4(0.0);
  // A cubic crosses the two ends of a range at most six times; colours and labels change at three places. Where rounding
  // makes more of them, the last section is the rest.
  int left = 10;
  section.uTo = 0.0;
  do {
    section.uFrom = section.uTo;
    bool held = sideOf(bernstein(path.focusAlong, section.uFrom)) == 0.0;
    section.inFocus = held && !ONLY_FOCUS;
    section.uTo = nextChange(path.focusAlong, section.uFrom);
    if (section.inFocus) section.uTo = min(section.uTo, nextColour(path.a, path.b, section.uFrom));
    else section.uTo = min(section.uTo, nextLabel(path.a, path.b, section.uFrom));
    if (--left == 0) section.uTo = 1.0;
    section.sFrom = mix(path.sFrom, path.sTo, section.uFrom);
    section.sTo = mix(path.sFrom, path.sTo, section.uTo);
    section.entries = bernsteinBetween(path.entries, section.uFrom, section.uTo);
    float middle = 0.5 * (section.uFrom + section.uTo);
    vec3 at = vec3(path.cell) + mix(path.a, path.b, middle);
    section.material = focusMaterial(at);
    findFunction(section, path, at);
    if (isShown(held))
      result = over(result, integrateSection(section, ray, cut, transmittance * (1.0 - result.a),
                                             share * (section.uTo - section.uFrom), bodies));
  } while (section.uTo < 1.0);
  return result;
}
