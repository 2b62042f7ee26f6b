// It counts how much of the focus is seen through the scan's ends (the interface is described in None.glsl).

const bool END_FACES = true;

shared vec4 sharedMore[64];

vec4 storedMore(vec4 more) { return more; }
vec4 restoredMore(vec4 more) { return more; }
