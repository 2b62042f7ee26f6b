#pragma once
// Exploded views: the parts that the context is cut into, and where forces move them to.
//
// After S. Bruckner, M. E. Gröller: Exploded views for volume data, IEEE TVCG 12(5) (IEEE Visualization), 2006: the
// context is cut into parts, each is moved rigidly, and return, explosion, viewing and spacing forces say where to.
// Their roles are the authors'; the formulas below are the program's own.
//
// Parts: one to three planes through the middle of the focus (FocusIndex::centre), or of the volume without a focus,
// cut the volume into 2, 4 or 8 cells. Their normals are unit and orthogonal: L, S and P of the patient, in this order,
// or the view's right, up and forward. The focus belongs to no part and stays where it is.
//
// Layout: in units of R, the radius of the volume's bounding sphere, and relative to the middle, c is where the middle
// of a part is, d its translation, p = c + d, q of another of the n parts, v the unit line of sight to the middle, and
// w = p - (p·v) v its offset from that line. At the degree of explosion e, a part is pulled and pushed by
//
//   return     -d                                       to its place
//   explosion  2e/3 · exp(-‖p‖) p/‖p‖                   away from the focus
//   viewing    e/3 · max(-p·v, 0)/‖p‖ · exp(-‖w‖) w/‖w‖   before the focus, out of the line of sight; to the right of
//                                                       the picture where w = 0
//   spacing    e/15 · Σ (p - q)/‖p - q‖³ / (n - 1)      away from the other parts
//
// From d = 0 on, d follows the sum of the forces until the parts are at rest. No part crosses a plane: along each
// plane's normal d points to the part's side or is 0. So the planes keep the parts disjoint wherever these are, and on
// every ray the stretches of the parts lie one behind the other.
//
// Picture: every part shows what clipping keeps of it, moved by its translation, with the focus left out. The focus
// shows at its place, from its first hit on each ray on, as if all of it lay there: before what the ray meets of parts
// behind that hit, and behind what it meets before.

#include <optional>
#include <vector>

#include "rendering/settings/Camera.h"
#include "rendering/settings/Clipping.h"
#include "rendering/vocabulary/MethodStages.h"

namespace fenestra {

struct Look;

/// How the context of a look's pictures is exploded; empty where it is not, or the cutaway is off.
std::optional<MethodStages::Explosion> explosionOf(const Look& look);

/// A part of an exploded view.
struct ExplodedPart {
  std::vector<HalfSpace> kept;  ///< what it is of the volume, in its place
  glm::dvec3 translation;       ///< world, mm
};

/// Where the parts are at rest, by a camera. Deterministic.
class ExplodedView {
 public:
  /// `middle`: world, of the focus, or of the volume.
  ExplodedView(const MethodStages::Explosion& explosion, const Grid& grid, glm::dvec3 middle, const Camera& camera);

  /// From the nearest to the farthest: along every ray of the camera, the stretches of the parts lie in this order.
  std::vector<ExplodedPart> parts() const;

  /// The parts are at rest when no force in a direction in which its part can move is greater, in units of R: in a
  /// volume of 1000 voxels from corner to corner, 1/2000 of a voxel.
  static constexpr double atRest = 1e-6;
  /// For tests: the sum of the forces on part i in units of R, and its translation in mm; both along the planes'
  /// normals, in which component k of part i is on the positive side where bit k of i is set.
  glm::dvec3 forceOn(std::size_t i) const;
  glm::dvec3 translation(std::size_t i) const { return radius_ * moved_[i]; }

 private:
  void place(const Grid& grid);
  bool isFree(std::size_t part, int axis, double force) const;
  double side(std::size_t part, int plane) const { return part >> plane & 1u ? 1.0 : -1.0; }

  MethodStages::Explosion explosion_;
  glm::dvec3 middle_;
  double radius_;                   ///< R, mm
  glm::dmat3 axes_;                 ///< columns: the planes' normals, world
  glm::dvec3 sight_, right_;        ///< along them: the line of sight to the middle, the view's right
  std::size_t nearest_ = 0;         ///< the part on the eye's side of every plane
  std::vector<glm::dvec3> places_;  ///< c, along the normals
  std::vector<glm::dvec3> moved_;   ///< d, along the normals
};

}  // namespace fenestra
