#include "rendering/scene/SeenPoint.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "rendering/scene/FaintLabels.h"

namespace fenestra {
namespace {

constexpr double stepShare = 0.25;  // of the least spacing
constexpr double leastTransmittance = 1e-3;
constexpr double valley = 0.5;      // of the peaks on both its sides: noise is no boundary
constexpr double farthestOn = 1.5;  // voxels from the surface into the structure

/// The scene along a ray; before t = 0, where the ray starts to see, only what the opening leaves.
class RaySamples {
 public:
  /// What shows at a point of the ray.
  enum class Part : std::uint8_t { Nothing, Context, Focus };

  RaySamples(const Scene& scene, glm::dvec3 start, glm::dvec3 direction)
      : scene_(scene),
        shown_(shownVolume(scene)),
        voxels_(shown_),
        structures_(structuresOf(scene)),
        protected_(labelsWith(LabelRole::Protected, scene)),
        kept_(halfSpaces(scene.look.clipping, scene.volume->grid)),
        start_(start),
        direction_(direction) {
    const FaintLabels faint = faintLabels(scene);
    context_ = contextFunctions(scene, faint);
    if (faint.any()) numberOfLabel_ = faint.numberOfLabel();
    const Grid& grid = scene.volume->grid;
    indexFromWorld_ = grid.indexFromWorld();
    const glm::dvec3 spacing = grid.spacing;
    voxel_ = std::min({spacing.x, spacing.y, spacing.z});
  }

  double step() const { return stepShare * voxel_; }
  double voxel() const { return voxel_; }
  glm::dvec3 worldAt(double t) const { return start_ + t * direction_; }
  bool isInside(double t) const {
    const glm::dvec3 index = indexAt(t), size(scene_.volume->grid.dims);
    return glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) && glm::all(glm::lessThan(index, size - 0.5)) &&
           keeps(kept_, worldAt(t));
  }
  double valueAt(double t) const { return voxels_.sample(indexAt(t)); }
  Part partAt(double t) const {
    if (t < 0.0) return isProtected(t) ? Part::Context : Part::Nothing;
    return isFocus(t) ? Part::Focus : Part::Context;
  }
  double extinctionAt(double t) const {
    const Part part = partAt(t);
    if (part == Part::Nothing) return 0.0;
    if (part == Part::Focus) return focusExtinctionAt(t);
    const double value = valueAt(t);
    if (!std::isfinite(value)) return 0.0;
    const std::size_t number = numberOfLabel_.empty() ? 0 : numberOfLabel_[labelAt(t, *structures_)];
    return context_[number].evaluate(value).extinction;
  }

 private:
  bool isFocus(double t) const {
    if (const auto* values = std::get_if<ValueFocus>(&scene_.look.focus)) {
      const double value = valueAt(t);
      return value >= values->values.low && value <= values->values.high && !voxels_.isGone(voxelAt(t));
    }
    const auto* labels = std::get_if<LabelFocus>(&scene_.look.focus);
    if (!labels || !scene_.labels || !isInside(t)) return false;
    return std::binary_search(labels->labels.begin(), labels->labels.end(), labelAt(t, *scene_.labels));
  }
  bool isProtected(double t) const {
    return structures_ && !protected_.empty() && isInside(t) &&
           std::binary_search(protected_.begin(), protected_.end(), labelAt(t, *structures_));
  }
  std::uint16_t labelAt(double t, const LabelMap& labels) const { return labels.value(voxelAt(t)); }
  glm::ivec3 voxelAt(double t) const {
    return glm::clamp(glm::ivec3(glm::floor(indexAt(t) + 0.5)), glm::ivec3(0), scene_.volume->grid.dims - 1);
  }
  double focusExtinctionAt(double t) const {
    const bool ofLabels = std::holds_alternative<LabelFocus>(scene_.look.focus);
    const auto byValue = ofLabels ? focusFunction(scene_, labelAt(t, *scene_.labels)) : focusFunction(scene_);
    if (byValue) return byValue->evaluate(valueAt(t)).extinction;
    return ofLabels ? focusMaterial(scene_, labelAt(t, *scene_.labels)).extinction
                    : scene_.look.focusAppearance.extinction;
  }
  glm::dvec3 indexAt(double t) const { return glm::dvec3(indexFromWorld_ * glm::dvec4(worldAt(t), 1.0)); }

  const Scene& scene_;
  ShownVolume shown_;
  ShownVoxels voxels_;                          ///< of shown_
  std::vector<TransferFunction> context_;       ///< contextFunctions()
  std::vector<std::uint8_t> numberOfLabel_;     ///< of them; empty where there is one for all
  std::shared_ptr<const LabelMap> structures_;  ///< null without labels
  std::vector<std::uint16_t> protected_;        ///< ascending
  std::vector<HalfSpace> kept_;                 ///< what clips the scene
  glm::dvec3 start_, direction_;
  glm::dmat4 indexFromWorld_{1.0};
  double voxel_ = 1.0;
};

/// A stretch of the ray that contributes without a valley in it.
struct Rise {
  double opacity = 0.0, peak = 0.0, peakAt = 0.0;
};

/// The rise with the largest opacity from `first` on.
Rise largestRise(const RaySamples& ray, double first, double length) {
  Rise best, now;
  double transmittance = 1.0, lowest = 0.0;
  const auto close = [&] {
    if (now.opacity > best.opacity) best = now;
    now = {};
  };
  for (double t = first + 0.5 * ray.step(); t < length && transmittance > leastTransmittance; t += ray.step()) {
    if (!ray.isInside(t)) {
      if (now.opacity > 0.0 || best.opacity > 0.0) break;
      continue;
    }
    const double passed = std::exp(-ray.extinctionAt(t) * ray.step());
    const double contribution = transmittance * (1.0 - passed);
    transmittance *= passed;
    if (now.peak > 0.0 && lowest <= valley * now.peak && contribution * valley > lowest) close();
    if (contribution > now.peak) {
      now.peak = lowest = contribution;
      now.peakAt = t;
    }
    lowest = std::min(lowest, contribution);
    now.opacity += contribution;
  }
  close();
  return best;
}

}  // namespace

std::optional<glm::dvec3> seenPoint(const Scene& scene, glm::dvec3 start, glm::dvec3 direction, double removed) {
  const RaySamples ray(scene, start, direction);
  const Grid& grid = scene.volume->grid;
  const Rise rise = largestRise(ray, -removed, glm::distance(start, grid.centre()) + grid.boundingRadius());
  if (rise.opacity <= 0.0) return std::nullopt;
  // The side that the values change to at the surface, and on to where they no longer do.
  const double half = 0.5 * ray.voxel();
  const RaySamples::Part part = ray.partAt(rise.peakAt);
  const double change = ray.valueAt(rise.peakAt + half) - ray.valueAt(rise.peakAt - half);
  double best = rise.peakAt;
  for (double t = best; t <= rise.peakAt + farthestOn * ray.voxel() && ray.isInside(t) && ray.partAt(t) == part;
       t += ray.step())
    if ((ray.valueAt(t) - ray.valueAt(best)) * change > 0.0) best = t;
  return ray.worldAt(best);
}

}  // namespace fenestra
