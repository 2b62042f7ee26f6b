#pragma once
// Which of the context's edges over the focus are drawn, where they may cover but a share of its projection
// (ContextLayer::share): the strongest. The renderer and its reference share what is computed here.
//
// A pixel's edge has the strength, 0 to 1,
//
//   u = (c · b / (b + usualBend) + s · r²) / (c + s)
//
// with b the curvature, dimensionless as in the layer's opacity, r = 1 - |n·v|, and c and s the weights of curvature
// and silhouette: bends without a limit must not outrank all outlines. Let n pixels show the focus. The least strength
// u₀ is the one that `share` · n of them exceed, and 0 where fewer have an edge at all. The layer's opacity at a pixel
// is multiplied by smoothstep(u₀, u₀ + fade, u): no more than the share is changed, lines grow thinner towards their
// crests, and where the strengths of neighbouring pixels change little, so does what is drawn.
//
// Strengths are counted in bins of equal width, with whole numbers, so that the order of counting does not matter;
// within a bin they count as spread evenly. Rays between pixels (EdgeRays.h) have the least strength of the pixels.
// Strokes of the brush have no part in it.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fenestra::lines {

inline constexpr double usualBend = 0.4, fade = 0.06;
inline constexpr std::size_t bins = 4096;
/// A least strength that keeps every edge whole.
inline constexpr double all = -1.0;

/// u, from c, s, b and r.
inline double strength(double curvature, double silhouette, double bend, double rim) {
  const double both = curvature + silhouette;
  return both > 0.0 ? (curvature * bend / (bend + usualBend) + silhouette * rim * rim) / both : 0.0;
}
inline std::size_t binOf(double strength) {
  return static_cast<std::size_t>(std::clamp(strength * double{bins}, 0.0, bins - 1.0));
}

/// u₀. `counts`: of edges by bin; `pixels`: that show the focus.
inline double leastStrength(std::span<const std::uint32_t> counts, std::uint32_t pixels, double share) {
  const double most = share * pixels;
  double above = 0.0;
  for (std::size_t bin = counts.size(); bin-- > 0;) {
    const double next = above + counts[bin];
    if (next > most)
      return (static_cast<double>(bin) + (next - most) / counts[bin]) / static_cast<double>(counts.size());
    above = next;
  }
  return 0.0;
}

}  // namespace fenestra::lines
