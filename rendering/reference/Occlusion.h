#pragma once
// Ambient occlusion and the soft shadow of rendering/scene/Occlusion.h in double precision.

#include <atomic>
#include <memory>
#include <vector>

#include "rendering/reference/Cells.h"
#include "rendering/reference/Reference.h"
#include "rendering/scene/Occlusion.h"

namespace fenestra::reference {

/// Extinction by cell, 1/mm, and what casts through it: plain data, so that tests can set it up by themselves.
struct OccludingMedium {
  Grid grid;           ///< of the voxels
  glm::ivec3 dims{0};  ///< cells
  glm::ivec3 side{1};  ///< voxels
  std::vector<double> extinction;

  /// Transmittance from the centre of a cell along a direction (unit, world) through the weighted medium.
  double transmittance(glm::ivec3 cell, glm::dvec3 direction, const occlusion::Weight& weight) const;
  double meanTransmittance(glm::ivec3 cell, const std::vector<glm::dvec3>& directions,
                           const occlusion::Weight& weight) const;
  double at(glm::ivec3 cell) const;
  double sideLength() const;  ///< mm
};

/// The scene's medium as its opening and clipping cut it. `stages` are those of a picture by `camera`, of `size`; null
/// without an opening.
OccludingMedium occludingMedium(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages* stages);

/// The shares of ambient and of direct light that reach a point. A node is computed when it is first asked for; any
/// thread may ask.
class Occlusion {
 public:
  /// As occludingMedium(). The light is that of `camera`.
  Occlusion(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages* stages);
  /// Occlusion in a given medium, with the light from a direction (unit, world).
  Occlusion(OccludingMedium medium, const Shading& shading, glm::dvec3 light,
            const occlusion::Directions& directions = {});

  /// At a continuous index position.
  glm::dvec2 at(glm::dvec3 index) const;
  glm::dvec2 atNode(glm::ivec3 cell) const;
  /// Appends where along a piece of a ray the interpolation has a kink; 0..1.
  void appendCrossings(const Piece& piece, std::vector<double>& places) const;

 private:
  glm::dvec2 compute(glm::ivec3 cell) const;

  OccludingMedium medium_;
  Shading shading_;
  std::vector<glm::dvec3> around_, towardsLight_;
  /// Two a node, NaN until they are known. Threads that compute a node at the same time find the same.
  std::unique_ptr<std::atomic<double>[]> nodes_;
};

}  // namespace fenestra::reference
