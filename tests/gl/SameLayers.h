#pragma once
// Whether two runs made every stage's image to the bit.

#include <string>

#include "rendering/Layers.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests {

/// Names of the images that differ, in the order of the stages; empty where all have the same bits.
inline std::string differingLayers(const Layers& a, const Layers& b) {
  std::string names;
  const auto compare = [&](const auto& one, const auto& other, const char* name) {
    if (!sameBits(one, other)) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  if (a.size != b.size) names = "size";
  compare(a.tContext, b.tContext, "context hits");
  compare(a.tFocus, b.tFocus, "focus hits");
  compare(a.tFocusFilled, b.tFocusFilled, "filled focus hits");
  compare(a.distance, b.distance, "distances");
  compare(a.edits, b.edits, "edits");
  compare(a.tStart, b.tStart, "ray starts");
  compare(a.focusLayer, b.focusLayer, "focus layer");
  compare(a.contextLayer, b.contextLayer, "context layer");
  compare(a.lens, b.lens, "lens");
  compare(a.walls, b.walls, "walls");
  compare(a.final, b.final, "picture");
  return names;
}

}  // namespace fenestra::tests
