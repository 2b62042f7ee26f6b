#pragma once
// The distances of a focal region that follows the focus's shape (rendering/scene/FocusDistances.h) on the device.

#include <cstdint>
#include <utility>

#include "rendering/gl/Buffer.h"
#include "rendering/scene/FocusDistances.h"
#include "rendering/scene/Scene.h"

namespace fenestra {

class FocalDistances {
 public:
  /// What the distances are made from: versions of the volume and of the focus of a GpuScene.
  using Key = std::pair<std::uint64_t, std::uint64_t>;
  /// Makes those of a scene whose context fades by them, and drops them where it does not.
  void update(const Scene& scene, Key key);
  void release() { *this = {}; }

  bool any() const { return static_cast<bool>(buffer_); }
  const SampledLattice& lattice() const { return lattice_; }
  void bind(unsigned binding) const { buffer_.bind(binding); }  ///< float, mm
  std::size_t bytes() const { return buffer_.bytes(); }

 private:
  SampledLattice lattice_;
  gl::Buffer buffer_;
  Key key_{};
};

}  // namespace fenestra
