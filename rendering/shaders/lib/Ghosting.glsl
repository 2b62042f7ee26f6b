// What the opening of a selection would remove is ghosted (MethodStages::Fading::Ghost in rendering/scene/Method.h). No
// file is included here that others include: those would lack it where FADING is not 3.

struct GhostSettings {
  float strength;
  float edgeSquare;  // of gradients of which the steepest is 1
  float outline;
};
// Uniforms of their own, as those of lib/Fading.glsl.
uniform float ghostStrength, ghostEdgeSquare, ghostOutline;
GhostSettings ghost = GhostSettings(ghostStrength, ghostEdgeSquare, ghostOutline);

// Of the invocation's ray, which lib/opening/Ghosted.glsl sets: the context is ghosted up to `end`, and from `holeBegin` to
// `holeEnd`; mm along the ray.
struct GhostSpans {
  float end, holeBegin, holeEnd;
};
GhostSpans ghosted = GhostSpans(-1e30, 1e30, 1e30);

bool isGhosted(float s) { return s < ghosted.end || (s > ghosted.holeBegin && s < ghosted.holeEnd); }

// Whether something from s to s' may be ghosted.
bool mayBeGhosted(float from, float to) { return from < ghosted.end || (to > ghosted.holeBegin && from < ghosted.holeEnd); }

// The first place behind s where a ghost begins or ends; s' where there is none before it.
float nextGhostEnd(float s, float last) {
  float next = last;
  if (ghosted.holeEnd > s) next = min(next, ghosted.holeEnd);
  if (ghosted.holeBegin > s) next = min(next, ghosted.holeBegin);
  if (ghosted.end > s) next = min(next, ghosted.end);
  return next;
}

// The binary logarithm of the factor at a point with this gradient, of a ray in this direction.
float fadeOfGhost(vec3 slope, vec3 direction) {
  float square = dot(slope, slope), along = dot(slope, direction);
  float edge = (square - ghost.outline * along * along) / (square + ghost.edgeSquare);
  float factor = 1.0 - ghost.strength * (1.0 - edge);
  return factor > 0.0 ? log2(factor) : -1e30;
}
