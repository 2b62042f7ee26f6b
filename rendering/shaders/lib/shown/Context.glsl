// The integral leaves out the focus (the interface is described in All.glsl).

const bool FOCUS_ALONE = false;

bool isShown(bool held) { return !held; }
