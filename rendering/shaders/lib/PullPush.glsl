// The finer of two levels. The finest is the hit-point map, which holds the focus hit in y.

#if FINEST
layout(rg32f) uniform readonly image2D fine;
float fineValue(ivec2 pixel) { return imageLoad(fine, pixel).y; }
#else
layout(r32f) uniform readonly image2D fine;
float fineValue(ivec2 pixel) { return imageLoad(fine, pixel).x; }
#endif
