#include "viewer/views/PreviewRenderer.h"

#include <atomic>
#include <optional>
#include <utility>

#include <QPainter>
#include <QPointer>

#include "rendering/Renderer.h"
#include "rendering/scene/Thinned.h"
#include "rendering/scene/VisibleFraming.h"
#include "viewer/style/Overlay.h"
#include "viewer/views/ScenePreparation.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {
namespace {

constexpr int pollMilliseconds = 15;
constexpr int mostVoxels = 96;  ///< along a side: as many as a preview has pixels

/// The volume as the views show it, without a CT's table, in few voxels.
std::shared_ptr<const Volume> smallVolume(const Scene& scene) {
  const ShownVolume shown = shownVolume(scene);
  const glm::ivec3 factor = (shown.volume->grid.dims + mostVoxels - 1) / mostVoxels;
  return thinned(shown, factor);
}

/// The look of a plain picture: what presets differ in at a glance.
Look plain(Look look) {
  look.focus = {};
  look.labels = {};
  look.strokes = {};
  look.cutaway.enabled = false;
  look.reconstruction = Reconstruction::Linear;  // too small to show
  look.labelSmoothing = LabelSmoothing::Off;
  look.hideTable = false;  // `smallVolume` did
  return look;
}

}  // namespace

struct PreviewRenderer::Order {
  Scene scene;
  std::vector<LookMaker> looks;
  QSize size;
  std::shared_ptr<GpuScene> views;  ///< the views' scene, whose programs and schedule are used here, too
  std::size_t next = 0;             ///< the next of `looks`

  std::shared_ptr<const Volume> small{};
  std::shared_ptr<GpuScene> gpuScene{};
  std::optional<Renderer> renderer{};
  Look look{};
  bool isBegun = false;
  QImage picture{};  ///< the next look's, once it is done

  /// Draws until the next picture is done or `stop` is set.
  void draw(const std::atomic<bool>& stop);
};

void PreviewRenderer::Order::draw(const std::atomic<bool>& stop) {
  if (!small) small = smallVolume(scene);
  if (!gpuScene) {
    gpuScene = std::make_shared<GpuScene>(views->programs());
    gpuScene->setSchedule(views->schedule());
    renderer.emplace(gpuScene);
  }
  if (!isBegun) {
    look = plain(looks[next]());
    Scene shown;
    shown.volume = small;
    shown.look = look;
    const Framing framing = visibleFraming(shownVolume(shown), look.context.shifted());
    renderer->begin(shown, {.camera = Camera::standard(StandardView::Anterior, framing, Projection::Perspective),
                            .size = {size.width(), size.height()}});
    isBegun = true;
  }
  bool isDone = false;
  while (!isDone && !stop) isDone = renderer->advance(0.0);
  if (!isDone) return;
  const std::vector<std::uint8_t> pixels = renderer->readPicture();
  picture = QImage(size, QImage::Format_RGB32);
  picture.fill(toColour(look.background));
  QPainter(&picture).drawImage(
      0, 0, QImage(pixels.data(), size.width(), size.height(), QImage::Format_RGBA8888_Premultiplied));
}

PreviewRenderer::PreviewRenderer(VolumeView& view) : view_(view) {
  connect(&timer_, &QTimer::timeout, this, &PreviewRenderer::goOn);
}

PreviewRenderer::~PreviewRenderer() { release(); }

void PreviewRenderer::request(const Scene& scene, std::vector<LookMaker> looks, QSize size, Made made) {
  release();
  order_ = std::make_shared<Order>(Order{scene, std::move(looks), size, view_.preparation().gpuScene()});
  made_ = std::move(made);
  timer_.start(pollMilliseconds);
}

void PreviewRenderer::release() {
  timer_.stop();
  if (!order_) return;
  view_.inGlContext([&](const auto&) {
    order_->renderer.reset();
    order_->gpuScene.reset();
  });
  order_.reset();
}

void PreviewRenderer::goOn() {
  if (isDrawing_ || view_.preparation().isBusy()) return;
  if (order_->next >= order_->looks.size()) return release();
  isDrawing_ = true;
  view_.preparation().runBehind([order = order_](const std::atomic<bool>& stop) { order->draw(stop); },
                                [self = QPointer(this), order = order_](std::exception_ptr error) {
                                  if (!self) return;
                                  self->isDrawing_ = false;
                                  if (self->order_ != order || (!error && order->picture.isNull()))
                                    return;  // stopped: it goes on later
                                  // The views say what is wrong with OpenGL, and the list of presets what is wrong with
                                  // a file.
                                  const QImage picture = std::exchange(order->picture, {});
                                  const std::size_t index = order->next++;
                                  order->isBegun = false;
                                  if (!picture.isNull()) self->made_(index, picture);
                                });
}

}  // namespace fenestra::viewer
