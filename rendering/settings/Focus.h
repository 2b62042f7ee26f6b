#pragma once
// What the user wants to see: a set of labels, a range of values, or a region grown from a click.

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "rendering/volume/Volume.h"

namespace fenestra {

/// The union of labels; its surface is the 0.5 level of the trilinearly interpolated 0/1 indicator, or where the look
/// smooths it (Look::labelSmoothing), of a SmoothedIndicator.
struct LabelFocus {
  std::vector<std::uint16_t> labels;  ///< sorted, unique, non-empty
  bool operator==(const LabelFocus&) const = default;
};

/// All points whose interpolated value lies in `values`, without connected components smaller than
/// `minimumComponent` mm³: a value range catches islands (a cable, a filling), and each would open a hole of its own.
/// A component is a 26-connected set of cells whose corner values overlap the range, so it is kept or dropped whole and
/// the surface stays a level set.
struct ValueFocus {
  ValueRange values;
  double minimumComponent = 300.0;
  bool operator==(const ValueFocus&) const = default;
};

/// A ball brush drawn along a polyline in space, which adds to a region or takes from it; rendering/segmentation/
/// Painting.h says which voxels.
struct SelectionStroke {
  std::vector<glm::dvec3> anchors;  ///< world, mm, at least one; one alone is a dab
  double radius = 10.0;             ///< mm, > 0
  double softness = 0.0;            ///< share of the radius, from the rim, in which only like values belong; 0..1
  bool adds = true;                 ///< else it takes away
  bool operator==(const SelectionStroke&) const = default;
};

/// Which voxels join a region, see rendering/segmentation/RegionGrowing.h.
enum class RegionRule : std::uint8_t {
  Values,  ///< those whose own values lie near the seeds'
  Tissues  ///< those that belong to a seed's tissue more than to the others of the volume
};

/// The region grown from seeds, and painted, see rendering/segmentation. What draws a scene knows labels and values
/// alone: segmentation::DrawnScene makes that of it.
struct RegionFocus {
  std::vector<glm::dvec3>
      inside;  ///< world mm; the first is the click, at least one lies in the volume, or none is there
  std::vector<glm::dvec3> outside;  ///< world mm: in structures that the region must not enter
  std::optional<double> tolerance;  ///< real values (HU for CT) below the seed's; empty: chosen from the plateaus
  std::vector<SelectionStroke> painted{};  ///< over what grows, in their order; without an inside seed at least one
  RegionRule rule = RegionRule::Values;
  double ball = 0.0;  ///< mm: no voxel farther from the first inside seed grows; 0: any may
  bool operator==(const RegionFocus&) const = default;
  /// Neither a seed inside nor a stroke.
  bool empty() const { return inside.empty() && painted.empty(); }
  /// What the region began with: the first click, else the first anchor; empty() has none.
  std::optional<glm::dvec3> origin() const {
    if (!inside.empty()) return inside.front();
    return painted.empty() || painted.front().anchors.empty() ? std::nullopt
                                                              : std::optional(painted.front().anchors.front());
  }
};

/// std::monostate: no focus, a plain volume rendering.
using Focus = std::variant<std::monostate, LabelFocus, ValueFocus, RegionFocus>;

}  // namespace fenestra
