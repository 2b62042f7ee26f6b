// "Nothing here", in every map of positions along rays, and what stands for infinity.

const float NONE = -1e30;
const float FAR = 1e30;

bool isNone(float s) { return s < -1e29; }
