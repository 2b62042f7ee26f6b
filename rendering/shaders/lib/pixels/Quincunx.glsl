// Rays run through the pixels of a quincunx (the interface is described in Lattice.glsl).
#include "lib/Region.glsl"

ivec2 pixelOf(int i) { return quincunxPixel(RAYS, i); }
