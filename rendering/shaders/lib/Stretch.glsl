// A stretch of a ray of an exploded view (rendering/scene/Explosion.h): in one of its parts, before or behind the focus's
// first hit, or in the focus. The rays of a part are those of a camera moved back by as much as the part is moved.
//
// EXPLODED is 0 in other pictures: nothing of this file is compiled then. It is 1 without a focus, and 2 with one; SHOWN
// (lib/integral/CellPath.glsl) says whether a program draws parts or the focus.
#include <opening>
#include "lib/None.glsl"
#if EXPLODED

uniform int resumes;  // 1: the layer holds stretches that lie before this one; 0: it holds anything

#if EXPLODED == 2
uniform sampler2D hitPoints;  // of the picture's rays
uniform int fromHit;          // 1: from the focus's first hit on; 0: up to it
uniform float fromPicture;    // s on the stretch's rays less s on the picture's

// From where to where the ray may see.
vec2 stretchOf(ivec2 pixel) {
  float hit = texelFetch(hitPoints, pixel, 0).y;
  float s = isNone(hit) ? FAR : hit + fromPicture;
  return mix(vec2(-FAR, s), vec2(s, FAR), bvec2(fromHit == 1));
}
#else
vec2 stretchOf(ivec2 pixel) { return vec2(-FAR, FAR); }
#endif

// `from`: of stretchOf(). The face that the ray enters by has its light as far as it reaches.
#if CLIPPED
Cut cutOf(Ray ray, float from) {
  Cut cut = Cut(max(ray.sIn, from), SHOWN == 2 ? 1u : 0u, 0.0, vec2(0.0));
  lightByCap(cut, ray);
#if CLIPPED == 2 && SHOWN != 2
  cut.onFocus = startsInFocus(ray) ? 1u : 0u;  // a face of a part shows no grey where the focus is left out of it
#endif
  return cut;
}
#else
Cut cutOf(Ray ray, float from) { return Cut(max(ray.sIn, from), 1u); }
#endif
#endif
