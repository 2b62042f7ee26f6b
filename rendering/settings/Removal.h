#pragma once
// What a user has carved out of a volume, in world space: it is gone from every 3-D picture, whatever the camera and
// the method; slices show all data.
//
// Ball, box and saw: S. W. Wang, A. E. Kaufman: Volume sculpting, Symposium on Interactive 3D Graphics 1995. Plane: O.
// Konrad-Verse, B. Preim, A. Littmann: Virtual resection with a deformable cutting plane, Simulation und Visualisierung
// 2004.

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

/// Ball: along the lines between its points. Box: at each point. Saw: a blade along the lines between its points,
/// pushed through the volume in one direction; where the last point is the first one, what they enclose goes, too.
/// Plane: laid through a stroke on a surface and bent; what lies on one side of it goes.
enum class RemovalShape : std::uint8_t { Ball, Box, Saw, Plane };

/// A drag of a plane along its normal by `distance` at a point, and by less around it: w times as far,
/// w = (1 - ρ²/radius²)², within the sphere of that radius around the point on the plane as the drags before have bent
/// it; ρ is the distance from there to a point of that plane. Its authors name a sphere of influence; this w is the
/// program's own.
struct Bend {
  glm::dvec3 point{0.0};  ///< world mm; counts where its normal to the unbent plane meets the plane
  double distance = 0.0;  ///< mm towards what is removed; negative: away from it
  double radius = 20.0;   ///< mm, > 0
  bool operator==(const Bend&) const = default;
};

struct Removal {
  RemovalShape shape = RemovalShape::Ball;
  std::vector<glm::dvec3> points;  ///< world mm; without any, nothing is removed
  double size = 10.0;              ///< mm, > 0. Ball: radius; saw: thickness of its blade
  glm::dvec3 sides{20.0};          ///< mm, > 0, of a box: across, along `up`, along `direction`
  /// World, of any length but 0. Saw: where it is pushed. Plane: towards what it removes. Box: of one of its sides.
  glm::dvec3 direction{0.0, 1.0, 0.0};
  glm::dvec3 up{0.0, 0.0, 1.0};  ///< world, of a box: not along `direction`, and made square to it
  /// mm, of saw and plane: how far they reach, a saw from the nearest of its points (and all the way before it), a
  /// plane from itself; 0: without an end.
  double depth = 0.0;
  double extent = 0.0;      ///< mm, of a plane: half the side of the square that it is; 0: without an end
  double softness = 0.0;    ///< mm across which the rim fades
  std::vector<Bend> bends;  ///< of a plane, in the order they were made
  bool operator==(const Removal&) const = default;
};

/// Each removes something; their order does not matter.
using Removals = std::vector<Removal>;

}  // namespace fenestra
