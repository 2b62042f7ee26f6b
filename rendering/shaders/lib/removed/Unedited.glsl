// No brush stroke has edited the opening that another camera cuts.
//
// Edited.glsl has the same interface; `#include <removed>` names the one that the opening needs:
//   EDITED      whether there are strokes
//   editFactor  what they leave of edges and border, at a place between four pixels of that camera's picture, from `corner` on
//   storeEdit   stores that for a pixel of this picture

const bool EDITED = false;

float editFactor(ivec2 corner, vec2 at) { return 1.0; }
void storeEdit(ivec2 pixel, float factor) {}
