#pragma once
// Views that a person would not take, though they show much of the focus.
//
// A habit costs a view of direction d a part of its worth. Costs count in shares of the focus's surface: a view that
// costs 0.1 has to show a tenth of the surface more. With the measures of ScanShape.h, and S the patient's axis,
//
//     cost(d) = 0.3 · throughCutEnd(d)      avoidCutEnds
//             + 0.1 · (d·S)²                uprightFirst
//             + 10 · edgeOn(d)                flatFromFront
//             + 0.1 · farSide(d)              nearSideFirst
//
// so that they grow smoothly from a good direction to a bad one. The second and the last are small: they decide between
// sides that show about as much, and a user's weights outweigh them. The third outweighs all else where a volume is
// flat.
//
// avoidCutEnds, moreover, refuses views: those within 45° of the axis of a cut end (throughCutEnd above ½), as long as
// another view, for C2 one of its region, shows at least two thirds as much of the focus's surface.

#include <glm/glm.hpp>

#include "rendering/settings/PlacementOptions.h"

namespace fenestra::placement {

struct ScanShape;

/// What the habits judge a direction by; each from 0, which is best, to 1.
struct Awkwardness {
  double throughCutEnd = 0.0;
  double lying = 0.0;  ///< (d·S)²: 1 from above and below, 0 from around the patient
  double edgeOn = 0.0;
  double farSide = 0.0;  ///< how much of the body lies in front of the focus, rather than behind it
};
/// `direction`: unit, towards the camera.
Awkwardness awkwardness(const ScanShape& shape, glm::dvec3 direction);

double costOf(const Awkwardness& view, const Habits& habits);
/// The cost of two views together: people look at C1 first, which is the one that costs less.
double costOfPair(double cost1, double cost2);

/// The views that may be chosen among some. What a view shows is given in any unit.
class CutEndRule {
 public:
  explicit CutEndRule(const Habits& habits) : applies_(habits.avoidCutEnds) {}
  /// One of the views to choose among.
  void add(const Awkwardness& view, double shows);
  bool admits(const Awkwardness& view, double shows) const;

 private:
  bool applies_;
  double othersShow_ = -1.0;  ///< the most that a view shows which comes in through no cut end
};

}  // namespace fenestra::placement
