// Rays run through the pixels of a list (the interface is described in Lattice.glsl).
#include "lib/PixelList.glsl"

ivec2 pixelOf(int i) { return listedPixel(i); }
