// What transfer functions have in common as tables and as segments. Emission is colour · extinction (1/mm); a material is
// emission and extinction.
#include <schedule>
#include "lib/Uniforms.glsl"

const float LAST_ENTRY = float(TABLE_SIZE - 1);

float entryOf(float stored) { return stored * transfer.map.x + transfer.map.y; }
