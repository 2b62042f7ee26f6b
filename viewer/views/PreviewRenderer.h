#pragma once
// Draws previews of looks in the pictures' OpenGL context, on another thread, from a copy of the volume with few
// voxels, so that the views' own voxels stay on the GPU.

#include <memory>

#include <QObject>
#include <QTimer>

#include "viewer/model/PreviewBackend.h"

namespace fenestra::viewer {

class VolumeView;

class PreviewRenderer : public QObject, public PreviewBackend {
  Q_OBJECT
 public:
  /// The view outlives this.
  explicit PreviewRenderer(VolumeView& view);
  ~PreviewRenderer() override;

  void request(const Scene& scene, std::vector<LookMaker> looks, QSize size, Made made) override;
  bool isBusy() const override { return timer_.isActive(); }

 private:
  struct Order;
  void goOn();
  /// Frees the order's objects on the GPU.
  void release();

  VolumeView& view_;
  std::shared_ptr<Order> order_;
  Made made_;
  QTimer timer_;
  bool isDrawing_ = false;
};

}  // namespace fenestra::viewer
