// The share that stays is the same everywhere. A part of the alternatives of `<faint>` without a lens.
#include "lib/faint/Layer.glsl"

const bool HAS_LENS = false;
uniform float faintOpacity;

float lensLine(ivec2 pixel) { return 0.0; }
