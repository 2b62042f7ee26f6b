// Light along straight paths through cells, for the integrals within a bound.
#include <focusNormals>
#include <light>
#include "lib/Crossing.glsl"
#include "lib/Uniforms.glsl"
#include "lib/fading/Slopes.glsl"

// Normals along a path: trilinear in the cell, so cubics, and known from the cell's corners alone. Bernstein coefficients.
struct CellNormals {
  vec3 gated[4];
  vec3 focus[4];
  Slopes slopes;
};

vec2 lightAlong(CellNormals normals, float u, vec3 rayDirection, bool ofFocus) {
  if (OWN_NORMALS) {
    vec3 smoothed = bernstein(normals.focus, u);
    if (ofFocus && dot(smoothed, smoothed) > FLAT_FOCUS) return lightOf(normalize(smoothed), rayDirection);
  }
  return lightOfGated(bernstein(normals.gated, u), rayDirection);
}

// The first u' > u, at most 1, where the context's normals turn from one side of the light to the other: |n·l| has a kink
// there.
float nextTurn(CellNormals normals, float u) {
  if (!LIT) return 1.0;
  return nextSignChange(vec4(dot(normals.gated[0], lighting.direction), dot(normals.gated[1], lighting.direction),
                             dot(normals.gated[2], lighting.direction), dot(normals.gated[3], lighting.direction)), u);
}

// Into how many pieces a part of a path, from u to u', has to be cut for the bends of its light that three points cannot
// tell. `weight`: how many times what is allowed a light of 1 would be.
float piecesOfLight(vec3 normals[4], float from, float to, float leastLength, vec3 rayDirection, float weight) {
  vec3 first = bernstein(normals, from), middle = bernstein(normals, 0.5 * (from + to)), last = bernstein(normals, to);
  vec3 front = normalize(first + 1e-12), back = normalize(last + 1e-12), between = normalize(middle + 1e-12);
  // Either side of a surface is lit alike.
  vec2 cosines = abs(vec2(dot(front, between), dot(between, back))), chords = sqrt(max(2.0 - 2.0 * cosines, 0.0));
  float turn = chords.x + chords.y, pieces = 0.5 * turn * sqrt(weight * lighting.diffuse / 24.0);

  // cos^shininess is much like a Gaussian of the standard deviation 1/√shininess: where a highlight may lie between two
  // points, they lie closer than that. A parabola through three points that far apart, weighted by what is seen of it,
  // is wrong by at most an 18th of the highlight, and by the third power of their distance.
  float cosine = abs(dot(between, normalize(lighting.direction - rayDirection)));
  float highlight = weight * lighting.specular * pow(min(cosine + 0.5 * turn, 1.0), lighting.shininess);
  float closer = max(pow(highlight * (1.0 / 18.0), 1.0 / 3.0), 1.0);
  if (highlight > 1.0) pieces = max(pieces, 0.5 * turn * sqrt(lighting.shininess) * closer);

  // Where normals turn from one side of the light to the other, |n·l| has a kink: a parabola through three points is in n
  // pieces wrong by at most 1/(4 n²) of the change from end to end, where most is seen of the kink itself.
  vec3 towards = vec3(dot(first, lighting.direction), dot(middle, lighting.direction), dot(last, lighting.direction));
  float low = min(min(towards.x, towards.y), towards.z), high = max(max(towards.x, towards.y), towards.z);
  float kink = low < 0.0 && high > 0.0 ? lighting.diffuse * min((high - low) / max(length(middle), leastLength), 2.0) : 0.0;
  return max(pieces, 0.5 * sqrt(weight * kink));
}

float piecesOfLight(CellNormals normals, float from, float to, bool ofFocus, vec3 rayDirection, float weight) {
  if (!LIT) return 0.0;
  if (OWN_NORMALS && ofFocus) {
    // Light jumps where the focus's own normals end. A parabola beside a jump is wrong by a third of it.
    vec3 first = bernstein(normals.focus, from), middle = bernstein(normals.focus, 0.5 * (from + to)),
         last = bernstein(normals.focus, to);
    vec3 squares = vec3(dot(first, first), dot(middle, middle), dot(last, last));
    bool jumps = any(greaterThan(squares, vec3(FLAT_FOCUS))) && any(lessThanEqual(squares, vec3(FLAT_FOCUS)));
    float pieces = jumps ? weight * (lighting.diffuse + lighting.specular) / 3.0 : 0.0;
    return max(pieces, piecesOfLight(normals.focus, from, to, 1e-3, rayDirection, weight));
  }
  // Shorter normals count for less: certainty over length is at most 9/8 of 1 / certainLength.
  return piecesOfLight(normals.gated, from, to, lighting.certainLength * 8.0 / 9.0, rayDirection, weight);
}
