#include "tests/bench/Measure.h"

#include "tests/bench/Text.h"

namespace fenestra::bench {

std::vector<Setting> unboundedSettings() { return {{"draft", Quality::Draft}, {"normal", Quality::Normal}}; }

std::vector<Setting> boundSettings(const std::vector<double>& bounds) {
  std::vector<Setting> settings;
  for (const double bound : bounds) settings.push_back({number(bound), Quality::Normal, bound});
  return settings;
}

Measurable prepare(const std::string& name, const Scene& scene, const Options& options, const TruthStore& truths) {
  Measurable result{name,
                    scene,
                    cameraPath(scene, options.views.cameras),
                    sampledPixels(options.views.size, options.views.pixelBlock),
                    {}};
  for (const Camera& camera : result.cameras)
    if (result.truths.size() < static_cast<std::size_t>(options.views.compared))
      result.truths.push_back(truths.colours(scene, camera, options.views.size, result.pixels));
  return result;
}

std::vector<Measured> measure(Renderer& renderer, const Measurable& what, const std::vector<Setting>& settings,
                              int rounds, const Options& options) {
  // A picture from elsewhere uploads, allocates and compiles what a setting needs, as the peers' first one does. One of
  // another size would not do: llvmpipe compiles apart for sizes that are powers of two.
  const Camera elsewhere = cameraPath(what.scene, 2 * options.views.cameras).back();
  std::vector<Measured> results(settings.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < settings.size(); ++k) {
      View view{elsewhere, options.views.size, 1.0, settings[k].quality};
      view.maxError = settings[k].maxError;
      timed([&] { renderer.render(what.scene, view); });
      for (std::size_t i = 0; i < what.cameras.size(); ++i) {
        view.camera = what.cameras[i];
        results[k].milliseconds.add(timed([&] { renderer.render(what.scene, view); }));
        if (round > 0 || i >= what.truths.size()) continue;
        const Layers layers = renderer.readLayers();
        results[k].errors.add(errorsOf(layers.final, what.truths[i], what, view.size));
      }
    }
  return results;
}

ColourErrors errorsOf(const std::vector<glm::vec4>& here, const std::vector<glm::dvec4>& truth, const Measurable& what,
                      glm::ivec2 size) {
  ColourErrors errors;
  for (std::size_t k = 0; k < what.pixels.size(); ++k) {
    const std::size_t at = static_cast<std::size_t>(what.pixels[k].y) * static_cast<std::size_t>(size.x) +
                           static_cast<std::size_t>(what.pixels[k].x);
    const double above = 1.0 - (what.pixels[k].y + 0.5) / size.y;
    errors.add(glm::dvec4(here[at]), truth[k], backgroundAt(what.scene.look, above));
  }
  return errors;
}

}  // namespace fenestra::bench
