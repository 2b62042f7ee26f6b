#include "rendering/ScheduleTrial.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>

#include "rendering/gl/Context.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra {
namespace {

constexpr int longestSide = 192;  ///< pixels: enough to fill a graphics card, few enough not to be noticed
constexpr int frames = 3;

View madeSmall(View view) {
  const double scale = std::min(1.0, double(longestSide) / std::max(view.size.x, view.size.y));
  view.size = glm::max(glm::ivec2(glm::round(glm::dvec2(view.size) * scale)), 1);
  view.pixelScale *= scale;
  return view;
}

/// Milliseconds of a frame that runs every pass.
double timeFrame(Renderer& renderer, const Scene& scene, const View& view) {
  const auto start = std::chrono::steady_clock::now();
  renderer.render(scene, view);
  if (gl::isSoftwareRasteriser()) {
    renderer.readPicture();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  double sum = 0.0;
  for (const PassStats& pass : renderer.stats()) sum += pass.milliseconds;
  return sum;
}

}  // namespace

ScheduleTimes tryBothSchedules(const std::shared_ptr<GpuScene>& gpuScene, const Scene& scene, const View& view) {
  constexpr std::array schedules{Schedule::Plain, Schedule::Llvmpipe};
  std::array<Renderer, 2> renderers{Renderer(gpuScene), Renderer(gpuScene)};
  std::array<double, 2> least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::array<std::exception_ptr, 2> refused;  // by the driver, at the first frame
  View small = madeSmall(view);
  // In turns, so that a machine whose speed changes treats both alike. The first frame compiles the programs.
  for (int frame = 0; frame <= frames; ++frame) {
    for (std::size_t i = 0; i < schedules.size(); ++i) {
      if (refused[i]) continue;
      gpuScene->setSchedule(schedules[i]);
      renderers[i].setTiming(!gl::isSoftwareRasteriser());
      try {
        const double time = timeFrame(renderers[i], scene, small);
        if (frame > 0) least[i] = std::min(least[i], time);
      } catch (const gl::ShaderError&) {
        refused[i] = std::current_exception();
        least[i] = std::numeric_limits<double>::infinity();
      }
    }
    // An unchanged view would run no pass: the eye moves by the least that a double can hold.
    small.camera.eye.x = std::nextafter(small.camera.eye.x, std::numeric_limits<double>::infinity());
  }
  if (refused[0] && refused[1]) std::rethrow_exception(refused[0]);
  const ScheduleTimes times{least[0], least[1]};
  gpuScene->setSchedule(times.faster());
  return times;
}

std::string scheduleKey(const Volume& volume) {
  return gl::description() + ", " + std::string(nameOf(volume.voxels.type()));
}

}  // namespace fenestra
