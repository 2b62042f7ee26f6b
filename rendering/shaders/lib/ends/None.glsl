// Whether the focus is seen through the scan's ends does not count.
//
// Faces.glsl has the same interface; `#include <ends>` names the one that the measure needs:
//   END_FACES                 whether it counts
//   sharedMore                what invocations share of Sums::more
//   storedMore, restoredMore  from and to Sums::more

const bool END_FACES = false;

shared float sharedMore[64];

float storedMore(vec4 more) { return more.x; }
vec4 restoredMore(float more) { return vec4(more, 0.0, 0.0, 0.0); }
