// Half-spaces clip the volume, and capped faces show it by its transfer function (the interface is described in None.glsl).
#include "lib/clip/HalfSpaces.glsl"

const bool GREY_FACES = false;
