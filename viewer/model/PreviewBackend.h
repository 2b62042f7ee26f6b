#pragma once
// Makes small pictures of a volume in several looks. The model asks; who draws is not its concern.

#include <functional>
#include <vector>

#include <QImage>
#include <QSize>

#include "rendering/scene/Scene.h"

namespace fenestra::viewer {

class PreviewBackend {
 public:
  using LookMaker = std::function<Look()>;
  using Made = std::function<void(std::size_t index, const QImage& picture)>;

  virtual ~PreviewBackend() = default;
  /// Draws the volume of `scene` from the front in each look, without a focus, one after the other and without blocking
  /// the window; drops an earlier order. `looks` are called on another thread; one that throws has no picture. `made`
  /// is called on this thread. `size` is in pixels.
  virtual void request(const Scene& scene, std::vector<LookMaker> looks, QSize size, Made made) = 0;
  virtual bool isBusy() const = 0;
};

}  // namespace fenestra::viewer
