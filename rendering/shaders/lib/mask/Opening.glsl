// The mask is all that an opening opens: also where its rays start behind the context's first hit (the interface is described
// in Projection.glsl).
#include <schedule>
#include "lib/None.glsl"

TEXELS_2D(r32f, starts);

bool isInside(ivec2 pixel, vec2 hit) {
  if (texelOf(starts, pixel).r > hit.x) return true;
  return !isNone(hit.y);
}
