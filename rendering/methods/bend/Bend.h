#pragma once
// What a plane that the user bends takes away is the opening: O. Konrad-Verse, B. Preim, A. Littmann: Virtual resection
// with a deformable cutting plane, Simulation und Visualisierung 2004. rendering/settings/Removal.h has the plane.

#include "rendering/vocabulary/MethodStages.h"

namespace fenestra {

namespace methods {

struct Bend {
  static constexpr const char* word = "bend";
  static constexpr const char* name = "Deformable cutting plane";
  static constexpr const char* description =
      "Nothing opens by itself: a plane that you lay through a stroke and bend by dragging removes one side of it "
      "(Konrad-Verse, Preim and Littmann 2004)";
  static constexpr bool carves = true;  ///< by the user's tools

  MethodStages stages() const { return MethodStages::withoutOpening(); }
  bool operator==(const Bend&) const = default;
};

}  // namespace methods

}  // namespace fenestra
