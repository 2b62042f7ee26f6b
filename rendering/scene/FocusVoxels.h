#pragma once
// Which voxels of a scene are in focus: those with one of its labels, or with a value in its range inside an island
// that is kept.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

struct Scene;

class FocusVoxels {
 public:
  FocusVoxels() = default;
  /// Finds the focus of the shown volume (Scene.h), also in a scene that does not open it. Runs on all cores.
  explicit FocusVoxels(const Scene& scene);

  bool holds(glm::ivec3 voxel) const {
    const glm::ivec3 in = voxel - low_;
    return !glm::any(glm::lessThan(in, glm::ivec3(0))) && !glm::any(glm::greaterThanEqual(in, size_)) &&
           held_[offset(in)] != 0;
  }
  /// A box around the voxels in focus, and for each voxel of the box, x fastest, whether it is one: 0 if not.
  glm::ivec3 low() const { return low_; }
  glm::ivec3 size() const { return size_; }
  std::span<const std::uint8_t> flags() const { return held_; }
  /// The least and the greatest coordinates of their centres along three unit vectors, mm from the world's origin;
  /// empty where there are none.
  struct Extent {
    glm::dvec3 low, high;
  };
  std::optional<Extent> extent(const glm::dmat3& axes) const;

 private:
  template <class Holds>
  void find(glm::ivec3 dims, const Holds& holds);
  std::size_t offset(glm::ivec3 in) const {
    return static_cast<std::size_t>(in.x) +
           static_cast<std::size_t>(size_.x) *
               (static_cast<std::size_t>(in.y) + static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(in.z));
  }

  glm::ivec3 low_{0}, size_{0};     ///< a box around them
  std::vector<std::uint8_t> held_;  ///< in it, x fastest
  glm::dmat4 worldFromIndex_{1.0};
};

}  // namespace fenestra
