// The finer of two levels. The finest is the hit-point map, which holds the focus hit in y.
#include <schedule>

#if FINEST
TEXELS_2D(rg32f, fine);
float fineValue(ivec2 pixel) { return texelOf(fine, pixel).y; }
#else
TEXELS_2D(r32f, fine);
float fineValue(ivec2 pixel) { return texelOf(fine, pixel).x; }
#endif
