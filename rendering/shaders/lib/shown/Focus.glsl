// The integral shows the focus alone (the interface is described in All.glsl).

const bool FOCUS_ALONE = true;

bool isShown(bool held) { return held; }
