#include "rendering/placement/Placer.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "rendering/placement/Sphere.h"

namespace fenestra::placement {
namespace {

/// A, P, L, R, S, I, as directions towards the camera (LPS).
const std::array<glm::dvec3, 6> standardDirections{glm::dvec3(0, -1, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0),
                                                   glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)};

/// Qualities closer than this, relative to their size, come from the candidates' pixels and say nothing.
constexpr double indistinct = 1e-3;

/// The spread candidates from `first` on.
std::vector<Candidate> spreadOf(const Measured& measured, std::size_t first) {
  const auto begin = measured.candidates.begin();
  return {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(measured.spread)};
}

double shareOf(const Measured& measured, const Placement& placement) {
  const Candidate& first = measured.candidates[*placement.c1];
  return seenShare(first, placement.c2 ? measured.candidates[*placement.c2] : first, measured.surfacePoints);
}

}  // namespace

Placement chooseDual(const Measured& measured, glm::dvec3 c1, const Options& options) {
  Placement placement;
  placement.c2 = dualView(spreadOf(measured, 0), c1, options);
  if (!placement.c2) placement.note = "no candidate in the region of C1 sees the focus";
  return placement;
}

Placement choose(const Measured& measured, const Options& options, bool joint) {
  Placement placement;
  const std::vector<Candidate> finest = spreadOf(measured, measured.coarser);
  placement.c1 = bestView(finest, options);
  if (!placement.c1) {
    placement.note = "no candidate sees the focus: it is empty";
    return placement;
  }
  *placement.c1 += measured.coarser;
  if (joint) {
    if (const auto pair = jointSearch(measured.candidates, measured.surfacePoints, options)) {
      placement.c1 = pair->c1;
      placement.c2 = pair->c2;
    }
  } else {
    placement.c2 = dualView(finest, measured.candidates[*placement.c1].direction, options);
    if (placement.c2) *placement.c2 += measured.coarser;
  }
  if (!placement.c2) placement.note = "no candidate in the region of C1 sees the focus";
  placement.share = shareOf(measured, placement);

  double least = 1e300, greatest = -1e300;
  for (std::size_t i = 0; i < measured.spread; ++i) {
    const double q = quality(measured.candidates[i].descriptors, options.weights);
    least = std::min(least, q);
    greatest = std::max(greatest, q);
  }
  if (greatest - least <= indistinct * std::max(std::abs(greatest), std::abs(least)))
    placement.note = "the focus looks the same from everywhere: the first direction is as good as any";
  else if (measured.surfacePoints == 0 && placement.c2)
    placement.note = "the focus fills the volume: it has no surface of which a share could be seen";
  return placement;
}

const Measured& Placer::measure(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options) {
  gpu.update(scene);
  const Key key{gpu.versions().volume, gpu.versions().focus, sampling,
                sampling.refined ? std::optional(options) : std::nullopt};
  if (key_ == key) return measured_;

  const FocusSurface surface = sampleSurface(scene, gpu.focus(), sampling.surfacePoints);
  Measured measured;
  measured.surfacePoints = surface.points.size();
  measured.surfaceArea = surface.area;
  if (sampling.refined) {
    Refined refined = refine(
        [&](const std::vector<glm::dvec3>& directions) {
          return images_.measure(gpu, directions, surface, sampling.side);
        },
        options);
    measured.candidates = std::move(refined.candidates);
    measured.coarser = refined.coarser;
  } else {
    const std::optional<int> nside = sideOf(sampling.count);
    if (!nside) throw std::invalid_argument(std::to_string(sampling.count) + " is not 12·nside²");
    measured.candidates = images_.measure(gpu, ringDirections(*nside), surface, sampling.side);
  }
  measured.spread = measured.candidates.size();
  const std::vector<glm::dvec3> standard(standardDirections.begin(), standardDirections.end());
  for (Candidate& candidate : images_.measure(gpu, standard, surface, sampling.side))
    measured.candidates.push_back(std::move(candidate));
  describeTogether(measured.candidates, measured.surfacePoints);
  measured_ = std::move(measured);
  key_ = key;
  return measured_;
}

}  // namespace fenestra::placement
