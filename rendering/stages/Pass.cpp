#include "rendering/stages/Pass.h"

#include <array>

namespace fenestra {

std::string_view nameOf(Pass pass) {
  constexpr std::array names = std::to_array<std::string_view>(
      {"hit points",  "important hits",  "pull-push",     "cones",         "distance map",
       "edit map",    "ray start",       "occlusion",     "focus layer",   "maximum",
       "faint layer", "protected layer", "context layer", "context lines", "lens",
       "walls",       "composite",       "exempt labels", "edges",         "edge rays"});
  static_assert(names.size() == passCount);
  return names[static_cast<std::size_t>(pass)];
}

}  // namespace fenestra
