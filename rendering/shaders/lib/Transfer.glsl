// What transfer functions have in common as tables and as segments. Emission is colour · extinction (1/mm); a material is
// emission and extinction.
#include <schedule>

struct TransferSettings {
  vec4 firstMaterial, lastMaterial;  // beyond the tables' ends
  vec2 map;                          // entry = stored value · x + y
  vec2 visibleEntries;               // nothing shows up to the first or from the second on
  int firstLevel;                    // of lib/PreIntegration.glsl
};
UNIFORM_BLOCK(TransferBlock, storedTransfer, TransferSettings, transfer);

const float LAST_ENTRY = float(TABLE_SIZE - 1);

float entryOf(float stored) { return stored * transfer.map.x + transfer.map.y; }
