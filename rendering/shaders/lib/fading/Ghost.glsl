// What the opening of a selection would remove is ghosted (rendering/methods/selection/Selection.h; the
// interface is described in None.glsl).
#include "lib/Crossing.glsl"
#include "lib/fading/Settings.glsl"

struct GhostSettings {
  float strength;
  float edgeSquare;  // of gradients of which the steepest is 1
  float outline;
};
// Uniforms of their own, as those of Settings.glsl.
uniform float ghostStrength, ghostEdgeSquare, ghostOutline;
GhostSettings ghost = GhostSettings(ghostStrength, ghostEdgeSquare, ghostOutline);

// The spans of the invocation's ray in which the context is ghosted, which lib/opening/Ghosted.glsl sets: up to `end`, and
// from `holeBegin` to `holeEnd`; mm along the ray.
struct GhostSpans {
  float end, holeBegin, holeEnd;
};
GhostSpans ghosted = GhostSpans(-1e30, 1e30, 1e30);

const bool FOLLOWS_LIGHT = false, BORDERS_IN_TURN = true;

float sharpnessOfFade() { return 0.0; }
vec4 outsideAlong(ivec3 cell, vec3 a, vec3 b) { return vec4(0.0); }

bool isGhosted(float s) { return s < ghosted.end || (s > ghosted.holeBegin && s < ghosted.holeEnd); }

bool mayFade(vec2 ends) { return ends.x < ghosted.end || (ends.y > ghosted.holeBegin && ends.x < ghosted.holeEnd); }

// The first place behind s where a ghost begins or ends; s' where there is none before it.
float nextGhostEnd(float s, float last) {
  float next = last;
  if (ghosted.holeEnd > s) next = min(next, ghosted.holeEnd);
  if (ghosted.holeBegin > s) next = min(next, ghosted.holeBegin);
  if (ghosted.end > s) next = min(next, ghosted.end);
  return next;
}

// At a point with this gradient, of a ray in this direction.
float fadeOfGhost(vec3 slope, vec3 direction) {
  float square = dot(slope, slope), along = dot(slope, direction);
  float edge = (square - ghost.outline * along * along) / (square + ghost.edgeSquare);
  float factor = 1.0 - ghost.strength * (1.0 - edge);
  return factor > 0.0 ? log2(factor) : -1e30;
}

float fadeOf(Slopes slopes, float along, Ray ray, float s, vec2 light) {
  vec3 slope = bernstein(slopes.along, along);
  return fadeOfGhost(slope, ray.world);
}

vec2 wholeBehind(Slopes slopes, vec2 within, Ray ray, vec2 ends, float x) {
  float size = max(ends.y - ends.x, 1e-6), s = mix(ends.x, ends.y, x), next = nextGhostEnd(s + 1e-6 * size, ends.y);
  float border = (next - ends.x) / size;
  return isGhosted(0.5 * (s + next)) ? vec2(border, 3e38) : vec2(-3e38, border);
}
