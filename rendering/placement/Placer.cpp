#include "rendering/placement/Placer.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "rendering/viewpoints/Sphere.h"

namespace fenestra::placement {
namespace {

/// The label in focus at or next to each point of the surface, which lies between a voxel of that label and one outside
/// the focus.
std::vector<std::uint16_t> labelsOf(const FocusSurface& surface, const Scene& scene) {
  std::vector<std::uint16_t> labels;
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  if (!focus || !scene.labels) return labels;
  const Grid& grid = scene.labels->grid;
  const auto labelAt = [&](glm::dvec3 index) {
    const glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::floor(index + 0.5)), glm::ivec3(0), grid.dims - 1);
    const std::uint16_t label = scene.labels->value(voxel);
    return std::binary_search(focus->labels.begin(), focus->labels.end(), label) ? label : std::uint16_t{0};
  };
  const glm::dmat3 indexFromWorld(grid.indexFromWorld());
  for (const FocusSurface::Point& point : surface.points) {
    std::uint16_t label = labelAt(point.index);
    // Steps of a quarter voxel into the focus reach the next voxel.
    const glm::dvec3 inwards = -indexFromWorld * point.normal;
    const glm::dvec3 step = 0.25 * inwards / std::max({std::abs(inwards.x), std::abs(inwards.y), std::abs(inwards.z)});
    for (int i = 1; label == 0 && i <= 6; ++i) label = labelAt(point.index + static_cast<double>(i) * step);
    labels.push_back(label);
  }
  return labels;
}

ScanShape scanOf(const FocusSurface& surface, const Scene& drawn, const std::vector<HalfSpace>& kept) {
  std::vector<glm::dvec3> points;
  for (const FocusSurface::Point& point : surface.points) points.push_back(point.index);
  return scanShape(shownVolume(drawn), kept, points);
}

}  // namespace

const Measured& Placer::measure(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options) {
  begin(gpu, scene, sampling, options);
  while (!advance(gpu, std::numeric_limits<std::size_t>::max())) {
  }
  return measured_;
}

Placer::Batch::Batch(std::vector<glm::dvec3> wanted) : directions(std::move(wanted)), measured(directions.size()) {
  const std::vector<std::optional<std::size_t>> opposites = oppositesOf(directions);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (opposites[i] && *opposites[i] < i) continue;
    order.push_back(i);
    if (opposites[i]) order.push_back(*opposites[i]);
  }
}

void Placer::begin(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options) {
  task_.reset();
  gpu.update(scene, GpuScene::Use::FirstHits);
  Key key{gpu.versions().volume,
          gpu.versions().focus,
          sampling,
          sampling.refined ? std::optional(options) : std::nullopt,
          std::nullopt,
          halfSpaces(scene.look.clipping, gpu.grid())};
  if (options.weights.endFace != 0.0)
    key.gaps = gpu.versions().gaps;
  else if (key_)
    key.gaps = key_->gaps;  // what was measured beyond the need does no harm
  if (key_ == key) return;
  if (options.weights.endFace == 0.0) key.gaps.reset();
  Task task{.key = key,
            .surface = sampleSurface(gpu.drawn(scene), gpu.focus(), sampling.surfacePoints),
            .refinement = {},
            .batch = Batch(),
            .measured = {}};
  task.measured.surfacePoints = task.surface.points.size();
  task.measured.surfaceArea = task.surface.area;
  task.measured.pointLabels = labelsOf(task.surface, gpu.drawn(scene));
  task.measured.scan = scanOf(task.surface, gpu.drawn(scene), key.kept);
  if (sampling.refined) {
    task.refinement.emplace(options, task.measured.surfacePoints);
    task.measured.refinedFor = options;
    task.batch = Batch(task.refinement->wanted());
  } else {
    const std::optional<int> nside = sideOf(sampling.count);
    if (!nside) throw std::invalid_argument(std::to_string(sampling.count) + " is not 12·nside²");
    std::vector<glm::dvec3> directions = ringDirections(*nside);
    directions.insert(directions.end(), standardDirections().begin(), standardDirections().end());
    task.batch = Batch(std::move(directions));
    task.standard = true;
  }
  task_ = std::move(task);
}

bool Placer::advance(const GpuScene& gpu, std::size_t count) {
  if (!task_) return true;
  Batch& batch = task_->batch;
  std::vector<glm::dvec3> directions;
  const std::size_t first = batch.done;
  for (; !batch.isDone(); ++batch.done) {
    const glm::dvec3 next = batch.directions[batch.order[batch.done]];
    // Opposite directions stay together however the work is sliced, so that results are bit-identical.
    if (directions.size() >= count && glm::dot(next, directions.back()) > -1.0 + 1e-12) break;
    directions.push_back(next);
  }
  const bool coarse = task_->refinement && task_->refinement->isLeading();
  const int side = CandidateImages::sideFor(gpu, task_->key.sampling.side) / (coarse ? 2 : 1);
  std::vector<Candidate> measured =
      images_.measure(gpu, directions, task_->surface, side, task_->key.gaps.has_value(), task_->key.kept);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    measured[i].descriptors.awkwardness = awkwardness(task_->measured.scan, measured[i].direction);
    batch.measured[batch.order[first + i]] = std::move(measured[i]);
  }
  if (!batch.isDone()) return false;

  if (!task_->standard) {
    task_->refinement->add(batch.measured);
    task_->standard = task_->refinement->wanted().empty();
    batch = Batch(task_->standard ? std::vector(standardDirections().begin(), standardDirections().end())
                                  : task_->refinement->wanted());
    return false;
  }
  finish();
  return true;
}

void Placer::finish() {
  std::vector<Candidate>& candidates = task_->measured.candidates;
  if (task_->refinement) {
    candidates = task_->refinement->candidates();
    task_->measured.coarser = task_->refinement->coarser();
  }
  for (Candidate& candidate : task_->batch.measured) candidates.push_back(std::move(candidate));
  task_->measured.spread = candidates.size() - standardDirections().size();
  describeTogether(candidates, task_->measured.surfacePoints);
  key_ = task_->key;
  measured_ = std::move(task_->measured);
  task_.reset();
}

double Placer::progress() const {
  if (!task_) return 1.0;
  if (task_->refinement) return task_->refinement->progress();
  return static_cast<double>(task_->batch.done) / static_cast<double>(task_->batch.order.size());
}

}  // namespace fenestra::placement
