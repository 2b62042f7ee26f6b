#pragma once
// What a picture is made from, beside the scene: a camera, a size and a sampling.

#include <optional>

#include <glm/glm.hpp>

#include "rendering/scene/Camera.h"
#include "rendering/scene/Quality.h"

namespace fenestra {

/// One picture to make.
struct View {
  Camera camera;
  glm::ivec2 size{0};       ///< rendered pixels, at least 1×1
  double pixelScale = 1.0;  ///< rendered pixels per device-independent pixel; widths in pixels scale with it
  Quality quality = Quality::Normal;
  /// Greatest error of a pixel's colour in 1/255 that sampling may leave; used instead of `quality`. It is kept by
  /// estimates: on the ten scenes of tests/bench/results by 99.99 % of the pixels.
  std::optional<double> maxError = std::nullopt;
  bool operator==(const View&) const = default;
};

}  // namespace fenestra
