#pragma once
// Measures candidate cameras and draws small pictures of them, in a 3-D view's OpenGL context and with its voxels.

#include <exception>
#include <functional>
#include <memory>
#include <optional>

#include "rendering/Renderer.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/placement/Placer.h"
#include "viewer/model/PlacementController.h"

namespace fenestra::viewer {

class VolumeView;

class PlacementRenderer : public PlacementBackend {
 public:
  /// The view outlives this.
  explicit PlacementRenderer(VolumeView& view) : view_(view) {}
  ~PlacementRenderer() override;

  void begin(const Scene& scene, const placement::Sampling& sampling, const placement::Options& options) override;
  bool advance() override;
  double progress() const override { return placer_ && !waiting_ && !isStarting_ ? placer_->progress() : 0.0; }
  const placement::Measured& measured() const override { return placer_->measured(); }
  QImage picture(const Scene& scene, const Camera& camera, QSize size) override;

 private:
  /// Runs `work` in the view's context. Throws std::runtime_error with a message for the user.
  void run(const std::function<void(const std::shared_ptr<GpuScene>&)>& work);
  /// Begins on another thread, with the first candidates: the focus's surface is sampled and programs are compiled.
  void start();

  /// What begin() was called with.
  struct Order {
    Scene scene;
    placement::Sampling sampling;
    placement::Options options;
  };

  VolumeView& view_;
  std::optional<Order> waiting_;  ///< waits for the context
  bool isStarting_ = false;
  std::exception_ptr failure_;
  std::optional<placement::Placer> placer_;
  std::size_t perSlice_ = 2;  ///< candidates
  std::optional<Renderer> renderer_;
};

}  // namespace fenestra::viewer
