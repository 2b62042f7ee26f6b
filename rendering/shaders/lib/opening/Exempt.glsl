// What clipping leaves out: only the labels that `<focus>` holds show there, alone and as part of the context (the
// interface is described in Closed.glsl).

const bool ONLY_FOCUS = true;

struct Cut {
  float start;   // mm along the ray
  uint onFocus;
};

vec2 behindCut(vec2 unchanged, Cut cut, float s) { return unchanged; }
