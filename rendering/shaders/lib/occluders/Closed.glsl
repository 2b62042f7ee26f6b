// Nothing of the context is removed.
//
// Opened.glsl has the same interface; `#include <occluders>` names the one that the picture needs:
//   visibleShare  the share of the context that is left at a place, in coordinates of the medium's cells

float visibleShare(vec3 place) { return 1.0; }
