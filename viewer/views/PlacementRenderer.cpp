#include "viewer/views/PlacementRenderer.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <QElapsedTimer>

#include "viewer/views/RenderProblem.h"
#include "viewer/views/ScenePreparation.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {
namespace {

/// Time that one slice may block the window: a frame at 30 Hz (33 ms), less a margin for slices slower than the last.
constexpr double placementSliceMilliseconds = 20.0;
constexpr std::size_t mostPerSlice = 256;
constexpr int contextMilliseconds = 4;  ///< before a slice asks for the context again

}  // namespace

PlacementRenderer::~PlacementRenderer() {
  view_.inGlContext([this](const std::shared_ptr<GpuScene>&) {
    placer_.reset();
    renderer_.reset();
  });
}

void PlacementRenderer::run(const std::function<void(const std::shared_ptr<GpuScene>&)>& work) {
  try {
    if (!view_.inGlContext(work)) throw std::runtime_error("the 3-D views are not on screen");
  } catch (const std::exception& error) {
    throw std::runtime_error(describeRenderProblem(error).toStdString());
  }
}

void PlacementRenderer::begin(const Scene& scene, const placement::Sampling& sampling,
                              const placement::Options& options) {
  waiting_ = Order{scene, sampling, options};
  failure_ = nullptr;
}

void PlacementRenderer::start() {
  isStarting_ = true;
  view_.preparation().runBehind(
      [this, order = *std::exchange(waiting_, std::nullopt),
       gpu = view_.preparation().gpuScene()](const std::atomic<bool>&) {
        if (!placer_) placer_.emplace();
        placer_->begin(*gpu, order.scene, order.sampling, order.options);
        placer_->advance(*gpu, 1);
      },
      [this](std::exception_ptr error) {
        isStarting_ = false;
        failure_ = error;
      });
}

bool PlacementRenderer::advance() {
  ScenePreparation& preparation = view_.preparation();
  if (preparation.isBusy()) {
    preparation.glContext().waitFor(contextMilliseconds);
    return false;
  }
  if (waiting_) {
    start();
    return false;
  }
  if (failure_) {
    const std::exception_ptr failure = std::exchange(failure_, nullptr);
    run([&](const std::shared_ptr<GpuScene>&) { std::rethrow_exception(failure); });
  }
  bool done = false;
  QElapsedTimer clock;
  clock.start();
  run([&](const std::shared_ptr<GpuScene>& gpu) { done = placer_->advance(*gpu, perSlice_); });
  // Sized for the speed of this slice, but at most doubled: the first slices also compile shaders.
  const double milliseconds = std::max(1e-3, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
  const double fitting = static_cast<double>(perSlice_) * std::min(2.0, placementSliceMilliseconds / milliseconds);
  perSlice_ = std::clamp(static_cast<std::size_t>(fitting), std::size_t{1}, mostPerSlice);
  return done;
}

QImage PlacementRenderer::picture(const Scene& scene, const Camera& camera, QSize size) {
  QImage picture(size, QImage::Format_RGBA8888_Premultiplied);
  run([&](const std::shared_ptr<GpuScene>& gpu) {
    if (!renderer_) renderer_.emplace(gpu);
    // Widths in pixels are chosen for a view about five times as large.
    constexpr double pixelScale = 0.2;
    // Crops the margins, which a small picture has no room for.
    constexpr double zoom = 1.3;
    renderer_->render(scene, {.camera = camera.zoomed(zoom),
                              .size = {size.width(), size.height()},
                              .pixelScale = pixelScale,
                              .quality = Quality::Normal});
    const std::vector<std::uint8_t> pixels = renderer_->readPicture();
    const auto stride = static_cast<std::size_t>(4 * size.width());
    for (int row = 0; row < size.height(); ++row)
      std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(stride * static_cast<std::size_t>(row)), stride,
                  picture.scanLine(row));
  });
  return picture;
}

}  // namespace fenestra::viewer
