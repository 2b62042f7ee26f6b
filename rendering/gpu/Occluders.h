#pragma once
// The cells that cast shadows (rendering/scene/Occlusion.h) on the device.

#include <cstdint>
#include <memory>
#include <tuple>

#include "rendering/gl/Buffer.h"
#include "rendering/gpu/FocusIndex.h"
#include "rendering/scene/Occlusion.h"

namespace fenestra {

class Occluders {
 public:
  /// What the cells are made from, beside the labels: versions of the parts of a GpuScene, and the focus's extinction.
  using Key = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t,
                         std::uint64_t, double>;
  /// Makes the cells of a scene whose light needs them, and drops them where it does not. Returns whether that changed
  /// anything. `focus` is the scene's.
  bool update(const Scene& scene, const FocusIndex& focus, const Key& key);
  void release() { *this = {}; }

  bool any() const { return static_cast<bool>(buffer_); }
  bool isOf(const Key& key) const { return any() && key == key_; }
  const OccluderCells& cells() const { return cells_; }
  void bind() const;  ///< for Occluders.comp
  std::size_t bytes() const { return buffer_.bytes(); }

 private:
  OccluderCells cells_;
  gl::Buffer buffer_;
  Key key_{};
};

}  // namespace fenestra
