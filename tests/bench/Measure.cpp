#include "tests/bench/Measure.h"

#include <cmath>

#include "tests/bench/Text.h"

namespace fenestra::bench {

std::vector<Setting> qualitySettings() {
  return {{"draft", Quality::Draft}, {"normal", Quality::Normal}, {"high", Quality::High}};
}

std::vector<Setting> boundSettings(const std::vector<double>& bounds) {
  std::vector<Setting> settings;
  for (const double bound : bounds) settings.push_back({number(bound), Quality::Normal, bound});
  return settings;
}

Measurable prepareTimes(const std::string& name, const Scene& scene, const Options& options) {
  return {name, scene, cameraPath(scene, options.views.cameras), {}, {}};
}

Measurable prepare(const std::string& name, const Scene& scene, const Options& options, const TruthStore& truths) {
  Measurable result = prepareTimes(name, scene, options);
  result.pixels = sampledPixels(options.views.size, options.views.pixelBlock);
  for (const Camera& camera : result.cameras)
    result.truths.push_back(truths.colours(scene, camera, options.views.size, result.pixels));
  return result;
}

Measured measure(Renderer& renderer, const Measurable& what, const Setting& setting, const Options& options) {
  View view;
  view.size = options.views.size;
  view.quality = setting.quality;
  view.maxError = setting.maxError;
  view.camera = what.cameras.back();
  timed([&] { renderer.render(what.scene, view); });
  Measured result;
  for (int round = 0; round < options.rounds; ++round)
    for (std::size_t i = 0; i < what.cameras.size(); ++i) {
      view.camera = what.cameras[i];
      // Of one camera, every other frame would be the one before: the eye moves by the least that a double can hold.
      if (what.cameras.size() == 1 && round % 2 == 0)
        view.camera.eye.x = std::nextafter(view.camera.eye.x, view.camera.eye.x + 1.0);
      result.milliseconds.add(timed([&] { renderer.render(what.scene, view); }));
      if (round > 0 || what.truths.empty()) continue;
      const Layers layers = renderer.readLayers();
      for (std::size_t k = 0; k < what.pixels.size(); ++k) {
        const glm::ivec2 pixel = what.pixels[k];
        const std::size_t at = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(options.views.size.x) +
                               static_cast<std::size_t>(pixel.x);
        result.errors.add(glm::dvec4(layers.final[at]), what.truths[i][k], what.scene.background);
      }
    }
  return result;
}

}  // namespace fenestra::bench
