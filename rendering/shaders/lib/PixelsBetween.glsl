// Adaptive sampling of the picture (after Levoy, "Volume rendering by adaptive refinement", 1990). Rays are traced through
// a lattice of pixels first. A pixel between lattice points is interpolated where the picture varies smoothly; otherwise it
// is put on a list and gets a ray of its own. First come the centres of the lattice's squares (CentresBetween.comp), then the
// middles of the squares' sides (SidesBetween.comp), which then have a known pixel on each side. In a quincunx every centre has
// been traced with the lattice (QuincunxBetween.comp).
#include "lib/PixelList.glsl"
#include "lib/Region.glsl"

layout(rgba32f) uniform image2D focusLayer;
uniform ivec2 pictureSize;
uniform float tolerance;  // of a colour, 0 … 1

float most(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }
vec4 known(ivec2 pixel) { return imageLoad(focusLayer, pixel); }
