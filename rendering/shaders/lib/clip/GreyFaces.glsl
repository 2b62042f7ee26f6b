// Half-spaces clip the volume, and capped faces show its values in grey (the interface is described in None.glsl).
#include "lib/clip/HalfSpaces.glsl"

const bool GREY_FACES = true;
