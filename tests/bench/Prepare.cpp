#include "tests/bench/Prepare.h"

namespace fenestra::bench {

Measurable prepare(const std::string& name, const Scene& scene, const Options& options, const TruthStore& truths) {
  Measurable result{name,
                    scene,
                    options.views.size,
                    cameraPath(scene, options.views.cameras, options.views.projection()),
                    sampledPixels(options.views.size, options.views.pixelBlock),
                    {}};
  for (const Camera& camera : result.cameras)
    if (result.truths.size() < static_cast<std::size_t>(options.views.compared))
      result.truths.push_back(truths.colours(scene, camera, options.views.size, result.pixels));
  return result;
}

}  // namespace fenestra::bench
