#pragma once
// The adaptive cutaway, the method of this program's paper. Its own settings are Cutaway's and ContextLayer's
// (rendering/settings/Cutaway.h), which other methods share.

#include "rendering/vocabulary/MethodStages.h"

namespace fenestra {

namespace methods {

struct Adaptive {
  static constexpr const char* word = "adaptive";
  static constexpr const char* name = "Adaptive cutaway";
  static constexpr const char* description =
      "An opening around the focus that rises to the surface over a width that you choose: the method of this program";

  MethodStages stages() const { return {}; }
  bool operator==(const Adaptive&) const = default;
};

}  // namespace methods

}  // namespace fenestra
