#include "rendering/viewpoints/LiveSync.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rendering/viewpoints/Placement.h"
#include "rendering/viewpoints/ScanShape.h"
#include "rendering/viewpoints/Sphere.h"
#include "rendering/volume/Threads.h"

namespace fenestra::placement {
namespace {

/// Rays for each direction: the mean transmittance is known to a few hundredths.
constexpr std::size_t raysPerView = 96;
/// Voxels: the widest gap within the structure that is not its end. Its border is a staircase, which a ray may leave
/// and enter.
constexpr double bridgedGap = 2.0;
/// Optical depth from which a ray shows nothing: less than 1e-8 of its light remains.
constexpr double opaqueDepth = 20.0;
/// Ratings are equal within this: far above rounding, and far below what a reader could tell apart.
constexpr double sameRating = 1e-9;

/// Which voxels belong to a structure.
class Members {
 public:
  explicit Members(const Structure& structure) : labels_(*structure.labels), isMember_(1 << 16, false) {
    for (const std::uint16_t value : structure.values) isMember_[value] = true;
  }
  bool operator()(glm::ivec3 index) const { return isMember_[labels_.value(index)]; }

 private:
  const LabelMap& labels_;
  std::vector<bool> isMember_;
};

/// Eigenvalues of a symmetric matrix, greatest first (Smith, Communications of the ACM 4(4), 1961).
std::array<double, 3> eigenvaluesOf(const glm::dmat3& m) {
  const double mean = (m[0][0] + m[1][1] + m[2][2]) / 3.0;
  const glm::dmat3 deviator = m - glm::dmat3(mean);
  double square = 0.0;
  for (int i = 0; i < 3; ++i) square += glm::dot(deviator[i], deviator[i]);
  const double spread = std::sqrt(square / 6.0);
  if (spread <= 0.0) return {mean, mean, mean};
  const double angle = std::acos(std::clamp(glm::determinant(deviator / spread) / 2.0, -1.0, 1.0)) / 3.0;
  const double greatest = mean + 2.0 * spread * std::cos(angle);
  const double least = mean + 2.0 * spread * std::cos(angle + 2.0 * std::numbers::pi / 3.0);
  return {greatest, 3.0 * mean - greatest - least, least};
}

/// The extinction (1/mm) of voxels that are not of the structure.
class Obstacles {
 public:
  explicit Obstacles(const Scene& scene)
      : context_(scene.look.context.shifted()), values_(std::get_if<ValueFocus>(&scene.look.focus)) {
    const auto constant = [](double extinction) { return TransferFunction{{{0.0, {glm::dvec3(1.0), extinction}}}}; };
    if (values_) materials_.push_back(focusFunction(scene).value_or(constant(scene.look.focusAppearance.extinction)));
    const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
    if (!focus || !scene.labels) return;
    labels_ = scene.labels.get();
    materialOf_.resize(1 << 16);
    for (const std::uint16_t label : focus->labels) {
      materials_.push_back(focusFunction(scene, label).value_or(constant(focusMaterial(scene, label).extinction)));
      materialOf_[label] = materials_.size();
    }
  }

  double extinction(glm::ivec3 index, double value) const {
    if (labels_)
      if (const std::size_t material = materialOf_[labels_->value(index)]; material > 0)
        return materials_[material - 1].evaluate(value).extinction;
    const bool isFocus = values_ && value >= values_->values.low && value <= values_->values.high;
    return (isFocus ? materials_.front() : context_).evaluate(value).extinction;
  }

 private:
  TransferFunction context_;
  const ValueFocus* values_;
  const LabelMap* labels_ = nullptr;
  std::vector<TransferFunction> materials_;  ///< of the focus
  std::vector<std::size_t> materialOf_;      ///< of a label: 1 + its place there; 0 outside the focus
};

/// The voxels that clipping removes.
class Clipped {
 public:
  explicit Clipped(const Scene& scene)
      : grid_(scene.volume->grid),
        worldFromIndex_(grid_.worldFromIndex()),
        kept_(halfSpaces(scene.look.clipping, grid_)),
        exempt_(scene.look.clipping.exempt),
        labels_(structuresOf(scene)) {}

  bool operator()(glm::ivec3 index) const {
    if (kept_.empty() || keeps(kept_, glm::dvec3(worldFromIndex_ * glm::dvec4(index, 1.0)))) return false;
    return !labels_ || !std::binary_search(exempt_.begin(), exempt_.end(), labels_->value(index));
  }

 private:
  const Grid& grid_;
  glm::dmat4 worldFromIndex_;
  std::vector<HalfSpace> kept_;
  std::vector<std::uint16_t> exempt_;
  std::shared_ptr<const LabelMap> labels_;
};

/// Share of the light that reaches a camera from a voxel of the structure. `step` is in voxels, `length` its mm.
template <class ValueAt>
double transmittance(const Grid& grid, glm::ivec3 from, glm::dvec3 step, double length, double gap,
                     const Members& isMember, const Obstacles& obstacles, const Clipped& isClipped,
                     const ValueAt& valueAt) {
  double depth = 0.0, outside = 0.0;
  for (int i = 0;; ++i) {
    const glm::ivec3 voxel(glm::floor(glm::dvec3(from) + (i + 0.5) * step + 0.5));
    if (!grid.contains(voxel)) return std::exp(-depth);
    if (isClipped(voxel)) continue;
    if (isMember(voxel)) {
      if (outside > gap) return 0.0;
      depth = outside = 0.0;
      continue;
    }
    outside += length;
    depth += length * obstacles.extinction(voxel, valueAt(voxel));
    if (depth > opaqueDepth && outside > gap) return 0.0;
  }
}

/// Voxels that stand for equal shares of the weights, and are not clipped.
std::vector<glm::ivec3> sampled(const LocalShape& shape, const Clipped& isClipped) {
  double sum = 0.0;
  std::vector<double> weights = shape.weights;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (isClipped(shape.voxels[i])) weights[i] = 0.0;
    sum += weights[i];
  }
  std::vector<glm::ivec3> voxels;
  const double share = sum / static_cast<double>(raysPerView);
  double running = 0.0, next = 0.5 * share;
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (running += weights[i]; weights[i] > 0.0 && next < running; next += share) voxels.push_back(shape.voxels[i]);
  return voxels;
}

/// The best of the candidates that `may` take and that no habit refuses.
template <class May>
std::optional<std::size_t> bestOf(const RatedViews& views, const std::vector<Awkwardness>& awkward,
                                  const Habits& habits, const May& may) {
  CutEndRule rule(habits);
  for (std::size_t i = 0; i < views.ratings.size(); ++i)
    if (may(views.directions[i])) rule.add(awkward[i], views.scores[i].visibility);
  std::optional<std::size_t> best;
  double greatest = 0.0;
  for (std::size_t i = 0; i < views.ratings.size(); ++i) {
    if (!may(views.directions[i]) || !rule.admits(awkward[i], views.scores[i].visibility)) continue;
    const double worth = views.ratings[i] - costOf(awkward[i], habits);
    if (best && worth <= greatest + sameRating) continue;
    best = i;
    greatest = worth;
  }
  return best;
}

ScanShape scanOf(const Scene& scene, const LocalShape& shape) {
  const std::vector<glm::dvec3> points(shape.voxels.begin(), shape.voxels.end());
  return scanShape(shownVolume(scene), halfSpaces(scene.look.clipping, scene.volume->grid), points);
}

}  // namespace

double orientationScore(glm::dvec3 direction) {
  constexpr double anterior = 1.0, lateral = 0.6, posterior = 0.4;  // superior and inferior: 0
  const glm::dvec3 square = direction * direction;
  return lateral * square.x + (direction.y < 0.0 ? anterior : posterior) * square.y;
}

double historyScore(glm::dvec3 direction, glm::dvec3 last) {
  return std::clamp(0.5 * (1.0 + glm::dot(direction, last)), 0.0, 1.0);
}

double LocalShape::score(glm::dvec3 direction) const {
  if (variances[0] <= 0.0) return 1.0;
  const double along = glm::dot(direction, covariance * direction);
  return std::clamp(1.0 - (along - variances[2]) / variances[0], 0.0, 1.0);
}

LocalShape localShape(const Structure& structure, glm::dvec3 pick, double reach) {
  LocalShape shape;
  const Grid& grid = structure.labels->grid;
  const Members isMember(structure);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dmat3 indexFromWorld(grid.indexFromWorld());
  const glm::dvec3 centre(grid.indexFromWorld() * glm::dvec4(pick, 1.0));
  glm::ivec3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    // The reach of a ball along an index axis: the length of that row of the transform.
    const double radius =
        reach * glm::length(glm::dvec3(indexFromWorld[0][axis], indexFromWorld[1][axis], indexFromWorld[2][axis]));
    const double last = grid.dims[axis] - 1;
    low[axis] = static_cast<int>(std::clamp(std::ceil(centre[axis] - radius), 0.0, last));
    high[axis] = static_cast<int>(std::clamp(std::floor(centre[axis] + radius), 0.0, last));
  }
  double sum = 0.0;
  glm::dvec3 first(0.0);
  glm::dmat3 second(0.0);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const glm::dvec3 offset = glm::dvec3(worldFromIndex * glm::dvec4(x, y, z, 1.0)) - pick;
        const double square = glm::dot(offset, offset) / (reach * reach);
        if (square >= 1.0 || !isMember({x, y, z})) continue;
        const double weight = (1.0 - square) * (1.0 - square);
        shape.voxels.emplace_back(x, y, z);
        shape.weights.push_back(weight);
        sum += weight;
        first += weight * offset;
        second += weight * glm::outerProduct(offset, offset);
      }
  if (sum <= 0.0) return shape;
  const glm::dvec3 mean = first / sum;
  shape.covariance = second / sum - glm::outerProduct(mean, mean);
  shape.variances = eigenvaluesOf(shape.covariance);
  for (double& variance : shape.variances) variance = std::max(0.0, variance);  // rounding
  return shape;
}

std::vector<double> visibilityScores(const Scene& scene, const Structure& structure, const LocalShape& shape,
                                     std::span<const glm::dvec3> directions) {
  std::vector<double> scores(directions.size(), 0.0);
  const Grid& grid = scene.volume->grid;
  const Members isMember(structure);
  const Obstacles obstacles(scene);
  const Clipped isClipped(scene);
  const std::vector<glm::ivec3> voxels = sampled(shape, isClipped);
  if (voxels.empty()) return scores;
  const double step = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
  const double gap = bridgedGap * std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z});
  const glm::dmat3 indexFromWorld(grid.indexFromWorld());
  withValues(shownVolume(scene), [&](const auto& valueAt) {
    parallelFor(directions.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const glm::dvec3 stride = indexFromWorld * (directions[i] * step);
        for (const glm::ivec3 voxel : voxels)
          scores[i] += transmittance(grid, voxel, stride, step, gap, isMember, obstacles, isClipped, valueAt);
        scores[i] /= static_cast<double>(voxels.size());
      }
    });
  });
  return scores;
}

double rating(const SphereScores& scores, const LiveSyncWeights& weights) {
  double sum =
      weights.orientation * scores.orientation + weights.shape * scores.shape + weights.visibility * scores.visibility;
  double total = weights.orientation + weights.shape + weights.visibility;
  if (scores.history) {
    sum += weights.history * *scores.history;
    total += weights.history;
  }
  return total > 0.0 ? sum / total : 0.0;
}

RatedViews rateViews(const Scene& scene, const Structure& structure, glm::dvec3 pick, int nside,
                     const LiveSyncOptions& options, const Options& usual, std::optional<glm::dvec3> last) {
  RatedViews views;
  views.directions = ringDirections(nside);
  views.directions.insert(views.directions.end(), standardDirections().begin(), standardDirections().end());
  views.shape = localShape(structure, pick, options.reach);
  const std::vector<double> visible = visibilityScores(scene, structure, views.shape, views.directions);
  const ScanShape scan = scanOf(scene, views.shape);
  std::vector<Awkwardness> awkward;
  for (std::size_t i = 0; i < views.directions.size(); ++i) {
    const glm::dvec3 direction = views.directions[i];
    views.scores.push_back({orientationScore(direction),
                            last ? std::optional(historyScore(direction, *last)) : std::nullopt,
                            views.shape.score(direction), visible[i]});
    awkward.push_back(awkwardness(scan, direction));
    views.ratings.push_back(rating(views.scores.back(), options.weights));
  }
  if (views.shape.voxels.empty()) return views;
  Habits habits = usual.habits;
  habits.uprightFirst = false;   // the sphere of the patient's orientation says that
  habits.nearSideFirst = false;  // and its visibility says this
  views.c1 = bestOf(views, awkward, habits, [](glm::dvec3) { return true; });
  views.c2 = bestOf(views, awkward, habits,
                    [&](glm::dvec3 direction) { return inRegion(views.directions[*views.c1], direction, usual); });
  return views;
}

Camera cameraAt(glm::dvec3 pick, glm::dvec3 direction, const Framing& framing, Projection projection) {
  Camera camera = Camera::fromDirection(direction, framing, projection);
  const glm::dvec3 moved = pick - camera.target;
  camera.eye += moved;
  camera.target += moved;
  return camera;
}

}  // namespace fenestra::placement
