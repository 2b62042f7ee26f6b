#pragma once
// Views of a point that was picked on a slice: four viewing spheres, and their combination.
//
// A viewing sphere gives each direction d (unit, world, towards the camera) a score from 0 to 1. The four criteria and
// the combination of their spheres are those of
//
//   P. Kohlmann, S. Bruckner, A. Kanitsar, M. E. Gröller: LiveSync: Deformed Viewing Spheres for Knowledge-Based
//   Navigation. IEEE TVCG 13(6), 2007; and, of the same authors, LiveSync++: Enhancements of an Interaction Metaphor.
//   Graphics Interface 2008.
//
// The formulas are this project's: simple functions that say what the criteria mean.
//
// Patient orientation: how usual it is to look from there. With d = (L, P, S), the squares of its components share 1
// among the six sides, so that the score changes smoothly between them:
//
//     orientation(d) = o(L) L² + o(P) P² + o(S) S²,   o = 1 anterior, 0.6 left and right, 0.4 posterior, 0 superior
//                                                         and inferior
//
// View history: history(d) = (1 + d·h) / 2, where h is the direction of the last camera. Without one, the sphere is
// left out of the combination.
//
// Local shape: C is the covariance of the positions x of the structure's voxels around the picked point p, each of
// weight w = (1 - |x - p|² / reach²)², which falls smoothly to 0 at `reach`; λ₁ ≥ λ₂ ≥ λ₃ are its eigenvalues
// (principal component analysis). The variance dᵀCd along d is what a picture from there does not show:
//
//     shape(d) = 1 - (dᵀCd - λ₃) / λ₁
//
// A plate is best seen along its normal (1; within its plane 0), a rod from any direction across it (1; along it 0),
// and a ball from everywhere alike (1).
//
// Visibility: the mean, by the same weights, of the transmittance between the structure and the camera. From a voxel of
// the structure a ray runs towards the camera. The stretch of the structure in which it begins hides nothing: its end
// is what the camera sees. Behind it the ray is attenuated by what the transfer function and the rest of the focus show
// (exp of minus the integral of extinction), and stopped where it meets the structure again. Gaps of two voxels or less
// within the structure do not end it. Clipped material does not count. A structure that is hidden from everywhere has
// the score 0 everywhere; then the other criteria decide. The opening of the context is not considered.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/scene/Scene.h"
#include "rendering/settings/PlacementOptions.h"

namespace fenestra::placement {

/// The voxels of a structure.
struct Structure {
  std::shared_ptr<const LabelMap> labels;  ///< on the volume's grid
  std::vector<std::uint16_t> values;       ///< of its voxels there
};

double orientationScore(glm::dvec3 direction);
double historyScore(glm::dvec3 direction, glm::dvec3 last);

/// The structure around a picked point.
struct LocalShape {
  glm::dmat3 covariance{0.0};         ///< mm²
  std::array<double, 3> variances{};  ///< mm²: λ₁, λ₂, λ₃
  std::vector<glm::ivec3> voxels;     ///< within reach, x fastest
  std::vector<double> weights;        ///< of the voxels
  double score(glm::dvec3 direction) const;
};
/// `pick` is in world mm. No voxels where the structure does not come within reach.
LocalShape localShape(const Structure& structure, glm::dvec3 pick, double reach);

/// The share of the structure around the pick that shows from each direction. Deterministic; runs on all cores. The
/// scene is as it is drawn.
std::vector<double> visibilityScores(const Scene& scene, const Structure& structure, const LocalShape& shape,
                                     std::span<const glm::dvec3> directions);

/// The scores of one direction on the spheres.
struct SphereScores {
  double orientation = 0.0;
  std::optional<double> history;  ///< empty without a last camera
  double shape = 0.0, visibility = 0.0;
};
/// Σ weight · score / Σ weight over the scores that there are; 0 where no weight is above 0.
double rating(const SphereScores& scores, const LiveSyncWeights& weights);

/// Candidates rated for one pick.
struct RatedViews {
  std::vector<glm::dvec3> directions;  ///< the spread ones, then the six standard views
  std::vector<SphereScores> scores;
  std::vector<double> ratings;
  LocalShape shape;
  std::optional<std::size_t> c1, c2;  ///< empty where the structure does not come within reach of the pick

  std::size_t spread() const { return directions.size() - 6; }
};

/// Rates 12·nside² directions for a pick (world mm) on a structure. C1 is the best one. C2 is the best one of its
/// region, as in the paper's placement (inRegion), so that the two views complement each other. Ratings that differ by
/// rounding are equal; among equal ones the lowest index is taken. `last` is the direction of the last camera.
/// The region and the habits are those of `usual`: what they cost is taken off the ratings, and views through cut ends
/// are refused, by their visibility, as Habits.h says. The preference for upright views is left to the patient's
/// orientation, that for the near side to the visibility.
RatedViews rateViews(const Scene& scene, const Structure& structure, glm::dvec3 pick, int nside,
                     const LiveSyncOptions& options, const Options& usual,
                     std::optional<glm::dvec3> last = std::nullopt);

/// The camera that looks at `pick` from a direction, as far away as one that has all of `framing` in its picture.
Camera cameraAt(glm::dvec3 pick, glm::dvec3 direction, const Framing& framing, Projection projection);

}  // namespace fenestra::placement
