#pragma once
// How fast this machine draws, and how exact: times of one picture against the error that it may have, of a plain
// volume rendering, the same with lighting, and the scene with its opening; of both cameras together; and what a user
// waits for at the start.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/benchmark/Machine.h"
#include "rendering/scene/Scene.h"

namespace fenestra {
class GpuScene;
}

namespace fenestra::bench {

struct BenchmarkOptions {
  bool isQuick = false;       ///< a few settings, once each, without the reference
  glm::ivec2 size{700, 650};  ///< of a picture, pixels; the figures of other machines are of 700×650
};

/// Times and errors of one setting in one scene.
struct SettingTime {
  std::string setting;                           ///< "draft", "normal" or a bound, as "0.5"
  std::optional<double> bound;                   ///< on the error of a pixel's colour, 1/255
  double least = 0.0, median = 0.0, most = 0.0;  ///< ms of a picture
  std::optional<double> error, rms;  ///< 99.99th percentile and RMS against the reference, 1/255; empty when quick
};
struct SceneTimes {
  std::string id;    ///< "plain", "lit" or "opened"
  std::string name;  ///< in English
  std::vector<SettingTime> settings;
};

struct BenchmarkResult {
  Machine machine;
  std::string schedule;  ///< that the shaders followed
  glm::ivec2 size{0};
  bool isQuick = false;
  double context = 0.0;  ///< ms until there was an OpenGL context; measured by the caller, as the next one
  double reading = 0.0;  ///< ms to make the phantom
  double first = 0.0;    ///< ms of the first picture: voxels are uploaded, and programs compiled or found
  double placing = 0.0;  ///< ms to measure 192 views and choose both cameras
  double both = 0.0;     ///< ms of the pictures of both cameras at normal quality, as one of them is turned
  std::vector<SceneTimes> scenes;
};

/// Measures `opened`, a scene with a focus and lighting. Needs a current context. `progress` gets a share of 0..1 and
/// what is being done. Throws RenderError, gl::ShaderError.
BenchmarkResult runBenchmark(const std::shared_ptr<GpuScene>& gpu, const Scene& opened, const BenchmarkOptions& options,
                             const std::function<void(double, std::string_view)>& progress = {});

}  // namespace fenestra::bench
