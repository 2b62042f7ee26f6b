// No label of the context is translucent (rendering/scene/FaintLabels.h).
//
// Labels.glsl has the same interface; `#include <translucent>` names the one that the scene needs. Translucent labels have
// numbers from 1 on; 0 is all else.
//   HAS_FAINT     whether there is a translucent label
//   labelsIn      the labels in a cell: the number of the one there, or a code where there are several
//   labelsDiffer  whether there are several, by that code
//   labelAt       the label at a position (cell frame)
//   nextLabel     the first u' > u, at most 1, where from a to b, both within a cell, the label may change
//   opacityOf     a label's opacity, by its number

const bool HAS_FAINT = false;

uint labelsIn(ivec3 cell) { return 0u; }
bool labelsDiffer(uint labels) { return false; }
int labelAt(vec3 at) { return 0; }
float nextLabel(vec3 a, vec3 b, float u) { return 1.0; }
float opacityOf(int label) { return 1.0; }
