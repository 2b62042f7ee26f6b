#pragma once
// A small translucent scene with an opening, for the passes that draw along rays, and how their pictures are compared.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/gl/PassTest.h"

namespace fenestra::tests {

/// Waves of values around a ball of label 1, in a translucent context.
inline Scene waves(bool lit) {
  const Grid grid = gridOf({22, 18, 20}, {1.0, 1.2, 1.1});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) / 4.0;
    return 500.0 + 400.0 * std::sin(p.x + 0.7 * p.z) * std::cos(p.y - 0.4 * p.x);
  });
  scene.labels = labelsOf(
      grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(11.0, 8.0, 9.5)) < 5.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.focusAppearance.extinction = 0.1;
  scene.look.context.function = {
      {{100.0, {{1.0, 0.2, 0.1}, 0.0}}, {500.0, {{0.8, 0.7, 0.3}, 0.05}}, {900.0, {{0.2, 0.4, 1.0}, 0.15}}}};
  scene.look.cutaway.openWidth = 5.0;
  scene.look.cutaway.borderWidth = 0.0;
  scene.look.contextLayer.strength = 0.0;
  scene.look.shading.enabled = lit;
  return scene;
}

inline Camera aside(const Scene& scene, Projection projection = Projection::Perspective) {
  return Camera::fromAngles(33.0, 21.0, scene.volume->grid, projection);
}

/// The pass's input: stages 1 to 4 of the reference, rounded to float32; and those rounded values for the reference.
struct MadeOpening {
  std::vector<glm::vec2> hits;
  std::vector<float> starts;
  reference::Stages truth;

  MadeOpening(const Scene& scene, const Camera& camera, glm::ivec2 size)
      : truth(reference::geometricStages(scene, camera, size)) {
    const RayFrame rays(camera, size, scene.volume->grid);
    for (std::size_t i = 0; i < pixelsIn(size); ++i) {
      hits.emplace_back(positionOf(truth.hits.tContext[i], rays), positionOf(truth.hits.tFocus[i], rays));
      starts.push_back(positionOf(truth.tStart[i], rays));
      truth.hits.tContext[i] = timeOf(hits[i].x, rays);
      truth.hits.tFocus[i] = timeOf(hits[i].y, rays);
      truth.tStart[i] = timeOf(starts[i], rays);
    }
  }
};

/// Differences of the worst channel, in 1/255.
struct Errors {
  double worst = 0.0, rms = 0.0;
};

inline Errors errorsOf(const std::vector<glm::vec4>& here, const std::vector<glm::dvec4>& truth) {
  if (here.size() != truth.size()) return {infinity, infinity};
  Errors errors;
  for (std::size_t i = 0; i < here.size(); ++i) {
    double most = 0.0;
    for (int channel = 0; channel < 4; ++channel) {
      const double error = 255.0 * std::abs(here[i][channel] - truth[i][channel]);
      most = std::isnan(error) ? infinity : std::max(most, error);
    }
    errors.worst = std::max(errors.worst, most);
    errors.rms += most * most;
  }
  errors.rms = std::sqrt(errors.rms / static_cast<double>(here.size()));
  return errors;
}

}  // namespace fenestra::tests
