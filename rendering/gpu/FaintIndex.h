#pragma once
// Where translucent labels are, for shaders/lib/labels/ByVoxel.glsl.

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "rendering/gl/Texture.h"
#include "rendering/scene/FaintLabels.h"

namespace fenestra {

/// A byte a voxel, in a box around the faint labels' voxels: the number of the label there (see FaintLabels), and 128
/// more where the eight voxels from that one up along each axis, clamped to the grid, have different ones. Empty while
/// no voxel has a faint label.
class FaintIndex {
 public:
  /// Returns whether it was remade. `labels` may be null. `kept`, ascending: the labels that are drawn, where they
  /// alone are. Their surface reaches half a voxel beyond them: a voxel beside them has the number of its first
  /// neighbour that is one of them (x fastest, from the lowest index).
  bool update(const FaintLabels& faint, const std::shared_ptr<const LabelMap>& labels,
              const std::vector<std::uint16_t>& kept = {});
  void release() { *this = {}; }

  bool any() const { return static_cast<bool>(texture_); }
  const gl::Texture& texture() const { return texture_; }
  glm::ivec3 origin() const { return origin_; }  ///< index of its first texel, -1 at the least

 private:
  gl::Texture texture_;
  glm::ivec3 origin_{0};
  // What it was made of.
  std::vector<std::pair<std::uint16_t, std::uint8_t>> numbers_;
  std::vector<std::uint16_t> kept_;
  std::shared_ptr<const LabelMap> map_;
};

}  // namespace fenestra
