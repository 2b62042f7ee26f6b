#include "tests/bench/RaySamples.h"

#include <algorithm>
#include <cmath>

#include "rendering/scene/Fading.h"

namespace fenestra::bench {

RaySampler::RaySampler(const Scene& scene)
    : scene_(scene),
      shown_(shownVolume(scene)),
      focus_(scene),
      focusShows_(scene),
      context_(scene),
      normals_(*scene.volume),
      steepest_(steepestSlope(*scene.volume)),
      focusCentre_(reference::focusCentre(scene)) {
  const glm::dvec3 spacing = scene.volume->grid.spacing;
  finestSpacing_ = std::min({spacing.x, spacing.y, spacing.z});
}

SampledRay RaySampler::along(const reference::Ray& ray, double from, const reference::Light& light) const {
  SampledRay sampled{ray, {}};
  const Grid& grid = scene_.volume->grid;
  const std::optional<reference::Span> span = reference::clip(ray, grid);
  if (!span || std::isnan(from)) return sampled;
  const double begin = std::max(span->tIn, from), length = span->tOut - begin;
  if (!(length > 0.0)) return sampled;
  const auto count = static_cast<int>(std::ceil(2.0 * length / finestSpacing_));
  const reference::Ray inIndex = reference::indexRay(ray, grid);
  withValues(shown_, [&](auto valueAt) {
    for (int i = 0; i < count; ++i) {
      const double t = begin + length * (i + 0.5) / count;
      std::optional<Stretch> stretch = stretchAt(inIndex.origin + t * inIndex.direction, ray, light, valueAt);
      if (!stretch) continue;
      stretch->begin = begin + length * i / count;
      stretch->end = begin + length * (i + 1) / count;
      sampled.stretches.push_back(*stretch);
    }
  });
  return sampled;
}

template <class ValueAt>
std::optional<Stretch> RaySampler::stretchAt(glm::dvec3 index, const reference::Ray& ray, const reference::Light& light,
                                             const ValueAt& valueAt) const {
  const Grid& grid = scene_.volume->grid;
  const glm::ivec3 cell(glm::floor(index));
  const glm::dvec3 place = index - glm::dvec3(cell);
  const double value = reference::interpolate(reference::cornersOf(cell, grid.dims, valueAt), place);

  Stretch stretch;
  if (focus_.mayHold(cell)) {
    const reference::Piece here{cell, 0.0, 0.0, place, place};
    if (const auto field = focus_.along(here, reference::Cubic{value, 0.0, 0.0, 0.0})) {
      const double inField = reference::evaluate(*field, 0.0);
      stretch.isFocus = inField >= focus_.range().low && inField <= focus_.range().high;
    }
  }
  if (stretch.isFocus) {
    const reference::FocusShow& show = focusShows_.at(index);
    stretch.extinction = show.function ? show.function->evaluate(value).extinction : show.material.extinction;
    if (!(stretch.extinction > 0.0)) return {};
  } else {
    stretch.extinction = context_.function().evaluate(value).extinction;
    if (!(opacityFromExtinction(stretch.extinction) > 1.0 / 255.0)) return {};
    findSlope(stretch, index, ray, light, valueAt);
  }
  stretch.label = labelAt(index, stretch.isFocus);
  return stretch;
}

std::uint16_t RaySampler::labelAt(glm::dvec3 index, bool isFocus) const {
  const LabelMap* labels = structuresOf(scene_).get();
  if (!labels) return 0;
  const auto at = [&](glm::ivec3 voxel) {
    return labels->value(glm::clamp(voxel, glm::ivec3(0), labels->grid.dims - 1));
  };
  const std::uint16_t nearest = at(glm::ivec3(glm::floor(index + 0.5)));
  const auto* focus = std::get_if<LabelFocus>(&scene_.look.focus);
  const auto isIn = [&](std::uint16_t label) {
    return std::binary_search(focus->labels.begin(), focus->labels.end(), label);
  };
  if (!isFocus || !focus || isIn(nearest)) return nearest;
  for (int i = 0; i < 8; ++i)
    if (const std::uint16_t label = at(glm::ivec3(glm::floor(index)) + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2));
        isIn(label))
      return label;
  return nearest;
}

template <class ValueAt>
void RaySampler::findSlope(Stretch& stretch, glm::dvec3 index, const reference::Ray& ray, const reference::Light& light,
                           const ValueAt& valueAt) const {
  const glm::ivec3 dims = scene_.volume->grid.dims, cell(glm::floor(index));
  std::array<glm::dvec3, 8> slopes, gated;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const auto bits = static_cast<int>(i);
    const glm::ivec3 corner = cell + glm::ivec3(bits & 1, (bits >> 1) & 1, bits >> 2);
    slopes[i] = normals_.gradient(glm::clamp(corner, glm::ivec3(0), dims - 1), valueAt);
    gated[i] = normals_.gated(slopes[i]);
  }
  const glm::dvec3 place = index - glm::dvec3(cell);
  if (steepest_ > 0.0) stretch.gradient = normals_.world(reference::interpolate(slopes, place)) / steepest_;
  stretch.slope = std::min(glm::length(stretch.gradient), 1.0);
  stretch.light =
      scene_.look.shading.enabled ? light.intensity(reference::interpolate(gated, place), ray.direction) : 1.0;
}

}  // namespace fenestra::bench
