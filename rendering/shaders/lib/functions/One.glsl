// The context has one transfer function, the volume's.
//
// ByLabel.glsl has the same interface; `#include <functions>` names the one that the scene needs. Functions are numbered from
// 0, the volume's.
//   HAS_FAINT        whether there is another one
//   functionsIn      the functions in a cell: the number of the one there, or a code where there are several
//   functionsDiffer  whether there are several, by that code
//   functionAt       the function at a position (cell frame)
//   nextFunction     the first u' > u, at most 1, where from a to b, both within a cell, the function may change

const bool HAS_FAINT = false;

uint functionsIn(ivec3 cell) { return 0u; }
bool functionsDiffer(uint functions) { return false; }
int functionAt(vec3 at) { return 0; }
float nextFunction(vec3 a, vec3 b, float u) { return 1.0; }
