// The integral shows focus and context.
//
// Context.glsl and Focus.glsl have the same interface; `#include <shown>` names the one that the picture needs. An exploded
// view draws its parts and the focus apart.
//   FOCUS_ALONE  whether the focus alone shows, with its own colours
//   isShown      whether something shows, which `<focus>` holds or not
#include <opening>

const bool FOCUS_ALONE = false;

bool isShown(bool held) { return held || !ONLY_FOCUS; }
