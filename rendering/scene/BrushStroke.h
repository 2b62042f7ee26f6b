#pragma once
// What the 2.5-D brush painted, kept in world space: a stroke survives camera moves and shows in every view.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

enum class BrushMode : std::uint8_t {
  Restore,     ///< brings the ray start back towards the eye: what the cutaway removed returns (an ear over a brain)
  Open,        ///< pushes the ray start away from the eye
  Fade,        ///< the context layer shows less under the stroke
  Strengthen,  ///< and more
};

/// A circular brush drawn along a polyline of points on what was seen.
struct BrushStroke {
  BrushMode mode = BrushMode::Restore;
  std::vector<glm::dvec3> anchors;  ///< world, mm; one point is a dab
  double radius = 5.0;              ///< mm, > 0
  double softness = 0.5;            ///< share of the radius, from the rim, over which the effect fades; 0..1
  double depth = 10.0;              ///< mm along the ray, ≥ 0: how far Restore and Open move the ray start at most
  double amount = 0.5;              ///< 0..1: how much of the context layer Fade and Strengthen take or add
  bool coversFocus = false;         ///< may hide the focus; otherwise rays that meet it keep seeing it
  bool hidden = false;              ///< kept, without effect
  int view = -1;                    ///< painted for one view alone (0: C1, 1: C2), as in the paper; -1: for all
  bool operator==(const BrushStroke&) const = default;
};

/// In the order they were painted, which is the order they apply in.
using BrushStrokes = std::vector<BrushStroke>;

}  // namespace fenestra
