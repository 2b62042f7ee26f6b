#pragma once
// The best view of the focus, and a quasi-orthogonal second one that complements it: descriptors to quality to cameras.
// No GL: CandidateImages supplies what is measured.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/settings/Camera.h"
#include "rendering/settings/PlacementOptions.h"
#include "rendering/viewpoints/Habits.h"

namespace fenestra::placement {

/// Sums over a candidate's image of first focus hits. The camera looks at the model's centre in parallel projection;
/// the image spans the model's bounding sphere, so every candidate sees all of the model at one scale.
struct ImageSums {
  double count = 0.0;        ///< focus pixels; one on the outline counts by its covered share
  double depth = 0.0;        ///< sum of depths, 0 at the near side of the sphere, 1 at the far side
  glm::dvec2 position{0.0};  ///< sum of positions, each -1…1 from left to right and from bottom to top
  /// Box of the pixels whose centres see the focus: x0, y0, x1, y1, rows from the top; empty when x1 < x0.
  glm::ivec4 box{0, 0, -1, -1};
  double ends = 0.0;  ///< focus pixels seen through an end of the scan, where that is measured
};

/// All in [0, 1]; the first three are the paper's.
struct Descriptors {
  double visibility = 0.0;  ///< vd1: mean depth over the sphere's diameter; larger is farther, as in the paper
  double coverage = 0.0;    ///< vd2: the focus pixels' share of the image
  double location = 0.0;    ///< vd3: 1 with the centroid in the middle of the image, 0 in a corner
  double entropy = 0.0;     ///< of the seen surface's distribution (Bordoloi, Shen 2005), over its logarithm's maximum
  double mutualInformation =
      0.0;                   ///< Σ p(o|v) log(p(o|v) / p(o)) (Viola et al. 2006), 1 where it is least: a typical view
  double stability = 0.0;    ///< 1 - Jensen–Shannon divergence to the nearest candidates (Bordoloi, Shen 2005)
  double orientation = 0.0;  ///< cosine to the nearest of the six anatomical directions
  /// The share of the focus's image that is seen through an end of the scan: of its rays, those whose first point of
  /// context or focus is where they enter the volume's box, so that they come in through a cut face of the body.
  double endFace = 0.0;
  /// What habits cost the view. Placer fills it in, as it depends on the scan; without, no direction is awkward.
  Awkwardness awkwardness;
};

/// One viewpoint: where it is, what it measures, which surface points it sees.
struct Candidate {
  glm::dvec3 direction{0.0};  ///< unit, world, from the model's centre towards the camera
  ImageSums sums;
  Descriptors descriptors;
  std::vector<std::uint64_t> seen;  ///< a bit for each point of the focus's surface; empty when not asked for
};

/// How many points of the focus's surface it sees.
double seenPoints(const Candidate& candidate);

/// vd1, vd2, vd3 and the orientation prior of an image of side² pixels.
Descriptors describe(const ImageSums& sums, int side, glm::dvec3 direction);
/// Fills in entropy, mutual information and stability, which depend on all candidates and on their seen points.
void describeTogether(std::vector<Candidate>& candidates, std::size_t points);

double quality(const Descriptors& descriptors, const Weights& weights);
/// The quality less what the options' habits cost the view: what single views are chosen by.
double worth(const Descriptors& descriptors, const Options& options);

/// Camera axes at a candidate: looking at the centre, the patient upright.
Camera::Axes axesAt(glm::dvec3 direction);
/// Whether C2 may look from `c2`: in the region of the options, and between 60° and 120° from C1.
bool inRegion(glm::dvec3 c1, glm::dvec3 c2, const Options& options);

/// Which candidates see the focus and are not refused by the options' habits.
std::vector<bool> admitted(const std::vector<Candidate>& candidates, const Options& options);

/// Index of the admitted candidate of greatest worth; ties go to the lowest. Empty when no candidate sees the focus.
std::optional<std::size_t> bestView(const std::vector<Candidate>& candidates, const Options& options);
/// Index of the best candidate, as bestView() has it, among those in c1's region.
std::optional<std::size_t> dualView(const std::vector<Candidate>& candidates, glm::dvec3 c1, const Options& options);

/// Share of the surface points that at least one of two candidates sees.
double seenShare(const Candidate& a, const Candidate& b, std::size_t points);

struct Pair {
  std::size_t c1 = 0, c2 = 0;
  double share = 0.0;
};
/// Both cameras at once: the pair, either in the other's region, that maximises shareWeight · share + (1 - shareWeight)
/// · mean quality - costOfPair(). Both are admitted, unless no such pair stands in either's region. A share is known to
/// about a hundredth, so pairs within 0.01 of the greatest value are equally good; among these the pair that looks
/// through least is taken, C1 before C2: the least 0.8 · f(c1) + 0.2 · f(c2), where f = visibility - 0.1 · orientation
/// + 2 · cost. Then ties go to the greater value, then to the lowest indices.
std::optional<Pair> jointSearch(const std::vector<Candidate>& candidates, std::size_t points, const Options& options);
/// The best orthogonal pair of the six standard views by share, among candidates that hold them.
std::optional<Pair> bestStandardPair(const std::vector<Candidate>& candidates, std::size_t points);

}  // namespace fenestra::placement
