#pragma once
// A focal region in double precision, as rendering/methods/focal-region/FocalRegion.h defines it.

#include <vector>

#include "rendering/reference/Reference.h"
#include "rendering/scene/FocusDistances.h"
#include "rendering/vocabulary/MethodStages.h"

namespace fenestra::reference {

class FocalRegion {
 public:
  /// A sphere or a box around a place.
  FocalRegion(const MethodStages::Fading::Region& region, glm::dvec3 middle) : region_(region), middle_(middle) {}
  /// The region of a scene; a FocalShape::Distance follows the scene's focus.
  FocalRegion(const MethodStages::Fading::Region& region, const Scene& scene);

  /// δ: mm that a place in the world lies outside.
  double distance(glm::dvec3 world) const;
  /// Share of contours that stays at a distance.
  double shareAt(double distance) const;
  /// Appends where a straight path, 0 at `from` and 1 at `to`, may enter or leave the region, and where the distance
  /// has a kink. For a FocalShape::Distance the path lies in one cell of the volume.
  void appendCrossings(glm::dvec3 from, glm::dvec3 to, std::vector<double>& places) const;

 private:
  /// D of FocusDistances.
  double fromFocus(glm::dvec3 world) const;

  MethodStages::Fading::Region region_;
  glm::dvec3 middle_{0.0};
  glm::ivec3 dims_{0};
  glm::dmat4 indexFromWorld_{1.0};
  FocusDistances distances_;
};

}  // namespace fenestra::reference
