#include "app/benchmark/Measurable.h"

#include "app/benchmark/Numbers.h"
#include "app/benchmark/Timed.h"

namespace fenestra::bench {

std::vector<Setting> unboundedSettings() { return {{"draft", Quality::Draft}, {"normal", Quality::Normal}}; }

std::vector<Setting> boundSettings(const std::vector<double>& bounds) {
  std::vector<Setting> settings;
  for (const double bound : bounds) settings.push_back({number(bound), Quality::Normal, bound});
  return settings;
}

std::vector<Measured> measure(Renderer& renderer, const Measurable& what, const std::vector<Setting>& settings,
                              int rounds) {
  // A picture from elsewhere uploads, allocates and compiles what a setting needs, as the peers' first one does. One of
  // another size would not do: llvmpipe compiles apart for sizes that are powers of two.
  const Camera elsewhere =
      cameraPath(what.scene, 2 * static_cast<int>(what.cameras.size()), what.cameras.front().projection).back();
  std::vector<Measured> results(settings.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < settings.size(); ++k) {
      View view{elsewhere, what.size, 1.0, settings[k].quality};
      view.maxError = settings[k].maxError;
      timed([&] { renderer.render(what.scene, view); });
      for (std::size_t i = 0; i < what.cameras.size(); ++i) {
        view.camera = what.cameras[i];
        results[k].milliseconds.add(timed([&] { renderer.render(what.scene, view); }));
        if (round > 0 || i >= what.truths.size()) continue;
        const Layers layers = renderer.readLayers();
        results[k].errors.add(errorsOf(layers.final, what.truths[i], what));
      }
    }
  return results;
}

ColourErrors errorsOf(const std::vector<glm::vec4>& here, const std::vector<glm::dvec4>& truth,
                      const Measurable& what) {
  ColourErrors errors;
  for (std::size_t k = 0; k < what.pixels.size(); ++k) {
    const std::size_t at = static_cast<std::size_t>(what.pixels[k].y) * static_cast<std::size_t>(what.size.x) +
                           static_cast<std::size_t>(what.pixels[k].x);
    const double above = 1.0 - (what.pixels[k].y + 0.5) / what.size.y;
    errors.add(glm::dvec4(here[at]), truth[k], backgroundAt(what.scene.look, above));
  }
  return errors;
}

}  // namespace fenestra::bench
