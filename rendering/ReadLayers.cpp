#include "rendering/ReadLayers.h"

#include <cmath>
#include <limits>
#include <span>

namespace fenestra {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// A position along a ray as the passes store it, in mm from the eye.
float timeOf(const RayFrame& rays, float position) {
  return isSomething(position) ? static_cast<float>(rays.distance() + position) : nan;
}

/// Nothing where there is no image.
template <class T>
std::vector<T> texelsOf(const Output& output) {
  if (!output) return {};
  const glm::ivec3 size = output.image.size();
  std::vector<T> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  output.image.readInto(std::span(texels));
  return texels;
}

std::vector<float> timesOf(const RayFrame& rays, const Output& output) {
  std::vector<float> times = texelsOf<float>(output);
  for (float& time : times) time = timeOf(rays, time);
  return times;
}

/// Where a camera's rays meet context and focus and where they start.
Layers startsOf(const RayFrame& rays, const Output& hits, const Output& starts) {
  Layers layers;
  layers.size = rays.size();
  for (const glm::vec2& hit : texelsOf<glm::vec2>(hits)) {
    layers.tContext.push_back(timeOf(rays, hit.x));
    layers.tFocus.push_back(timeOf(rays, hit.y));
  }
  layers.tStart = timesOf(rays, starts);
  return layers;
}

/// For the picture's camera; nothing but the size where nothing is opened.
Layers ownStartsOf(const Chain& chain) {
  const Frame& frame = *chain.frame();
  const PictureStarts& starts = chain.stages().starts;
  if (frame.hasCutaway) return startsOf(frame.own.rays, starts.hits(), starts.starts());
  Layers layers;
  layers.size = frame.own.rays.size();
  return layers;
}

std::vector<float> distancesIn(const Output& output, glm::dvec2 widths) {
  std::vector<float> distances = texelsOf<float>(output);
  for (float& distance : distances)
    if (distance > widths.x + widths.y) distance = std::numeric_limits<float>::infinity();
  return distances;
}

/// `tFocus`: the focus's projection, where alone the layer holds something.
std::vector<glm::vec4> contextLayerIn(const Output& output, const std::vector<float>& tFocus,
                                      const VolumeTexture& coding) {
  std::vector<glm::vec4> texels = texelsOf<glm::vec4>(output);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    glm::vec4& texel = texels[i];
    texel = i < tFocus.size() && !std::isnan(tFocus[i]) && isSomething(texel.x)
                ? glm::vec4(glm::vec3(texel), static_cast<float>(coding.slope * texel.w + coding.offset))
                : glm::vec4(nan);
  }
  return texels;
}

std::vector<glm::vec4> lensIn(const Output& output) {
  std::vector<glm::vec4> texels = texelsOf<glm::vec4>(output);
  for (glm::vec4& texel : texels)
    if (!isSomething(texel.w)) texel.w = nan;
  return texels;
}

}  // namespace

Layers readOpeningOf(const Chain& chain) {
  const Frame& frame = *chain.frame();
  const PictureStages& stages = chain.stages();
  if (frame.other) return startsOf(frame.other->rays, stages.opening.opened.hits(), stages.opening.starts.starts());
  return ownStartsOf(chain);
}

Layers readLayersOf(const Chain& chain) {
  const Frame& frame = *chain.frame();
  const PictureStages& stages = chain.stages();
  Layers layers = ownStartsOf(chain);
  layers.tFocusFilled = timesOf(frame.own.rays, stages.own.fill.filled());
  layers.distance = distancesIn(stages.starts.distances(), frame.widths());
  layers.edits = texelsOf<glm::vec2>(stages.starts.edits());
  layers.contextLayer = contextLayerIn(stages.contextLayer.layer(), layers.tFocus, chain.gpu().volume());
  layers.lens = lensIn(stages.lens.surface());
  layers.focusLayer = texelsOf<glm::vec4>(stages.focusLayer.layer());
  layers.faintLayer = texelsOf<glm::vec4>(stages.faintLayer.layer());
  layers.protectedLayer = texelsOf<glm::vec4>(stages.protectedLayer.layer());
  layers.walls = texelsOf<glm::vec4>(firstOf({stages.wallsInside.layer(), stages.wallsAround.layer()}));
  layers.final = texelsOf<glm::vec4>({chain.picture(), {}});
  return layers;
}

}  // namespace fenestra
