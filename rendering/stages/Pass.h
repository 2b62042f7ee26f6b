#pragma once
// The passes that a picture is made of, as statistics tell them apart.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fenestra {

/// In the order in which they run. A stage counts its runs as one of them; several stages may count as the same.
enum class Pass : std::uint8_t {
  HitPoints,
  Importance,
  PullPush,
  Cones,
  DistanceMap,
  EditMap,
  RayStart,
  Occlusion,
  FocusLayer,
  Maximum,
  FaintLayer,
  ProtectedLayer,
  ContextLayer,
  ContextLines,
  Lens,
  Walls,
  Composite,
  Exempt,
  Edges,
  EdgeRays
};
inline constexpr std::size_t passCount = static_cast<std::size_t>(Pass::EdgeRays) + 1;
std::string_view nameOf(Pass pass);

struct PassStats {
  std::uint64_t runs = 0;     ///< since the renderer was made
  std::uint64_t pixels = 0;   ///< shaded by the last run: under a changed brush stroke only, or the whole picture
  double milliseconds = 0.0;  ///< GPU time of the last run; 0 until timing is on
};

}  // namespace fenestra
