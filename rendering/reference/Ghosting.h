#pragma once
// A ghost of what an opening would remove in double precision, as
// rendering/methods/selection/Selection.h defines it.

#include "rendering/vocabulary/MethodStages.h"

namespace fenestra::reference {

class Ghosting {
 public:
  explicit Ghosting(const MethodStages::Fading::Ghost& ghost) : ghost_(ghost) {}

  /// e: how much of an edge a place is, seen in a direction of unit length. `gradient`: world, 1 for the steepest.
  double edge(glm::dvec3 gradient, glm::dvec3 direction) const {
    const double square = glm::dot(gradient, gradient), along = glm::dot(gradient, direction);
    return (square - ghost_.outline * along * along) / (square + ghost_.edge * ghost_.edge);
  }

  /// m: the share of the extinction that stays.
  double factor(glm::dvec3 gradient, glm::dvec3 direction) const {
    return 1.0 - ghost_.strength * (1.0 - edge(gradient, direction));
  }

 private:
  MethodStages::Fading::Ghost ghost_;
};

}  // namespace fenestra::reference
