#include "rendering/placement/Placer.h"

#include <algorithm>
#include <array>
#include <limits>
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
  begin(gpu, scene, sampling, options);
  while (!advance(gpu, std::numeric_limits<std::size_t>::max())) {
  }
  return measured_;
}

void Placer::begin(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options) {
  task_.reset();
  gpu.update(scene);
  const Key key{gpu.versions().volume, gpu.versions().focus, sampling,
                sampling.refined ? std::optional(options) : std::nullopt};
  if (key_ == key) return;
  Task task{.key = key,
            .options = options,
            .surface = sampleSurface(scene, gpu.focus(), sampling.surfacePoints),
            .directions = {},
            .measured = {}};
  task.measured.surfacePoints = task.surface.points.size();
  task.measured.surfaceArea = task.surface.area;
  if (!sampling.refined) {
    const std::optional<int> nside = sideOf(sampling.count);
    if (!nside) throw std::invalid_argument(std::to_string(sampling.count) + " is not 12·nside²");
    task.directions = ringDirections(*nside);
  }
  task.directions.insert(task.directions.end(), standardDirections.begin(), standardDirections.end());
  task_ = std::move(task);
}

bool Placer::advance(const GpuScene& gpu, std::size_t count) {
  if (!task_) return true;
  std::vector<Candidate>& candidates = task_->measured.candidates;
  const int side = CandidateImages::sideFor(gpu, task_->key.sampling.side);
  const auto measureAll = [&](const std::vector<glm::dvec3>& directions) {
    return images_.measure(gpu, directions, task_->surface, side);
  };
  if (task_->key.sampling.refined && candidates.empty()) {
    Refined refined = refine(measureAll, task_->options);
    candidates = std::move(refined.candidates);
    task_->measured.coarser = refined.coarser;
    task_->measured.spread = candidates.size();
    // The standard views are still to come.
    return false;
  }
  const std::size_t refined = task_->key.sampling.refined ? task_->measured.spread : 0;
  const auto first = task_->directions.begin() + static_cast<std::ptrdiff_t>(candidates.size() - refined);
  const auto left = static_cast<std::size_t>(task_->directions.end() - first);
  for (Candidate& candidate : measureAll({first, first + static_cast<std::ptrdiff_t>(std::min(count, left))}))
    candidates.push_back(std::move(candidate));
  if (left > count) return false;

  task_->measured.spread = candidates.size() - standardDirections.size();
  describeTogether(candidates, task_->measured.surfacePoints);
  key_ = task_->key;
  measured_ = std::move(task_->measured);
  task_.reset();
  return true;
}

double Placer::progress() const {
  if (!task_) return 1.0;
  if (task_->key.sampling.refined) return 0.0;
  return static_cast<double>(task_->measured.candidates.size()) / static_cast<double>(task_->directions.size());
}

}  // namespace fenestra::placement
