#pragma once
// How much of each voxel is removed.
//
// A voxel's coverage is that of its centre: with d the signed distance (mm) to a line of a ball's path, to a box, a
// saw's cut or a plane's side, negative inside,
//
//   coverage = clamp(½ - d / max(softness, 2 w), 0, 1)
//   w = min(√Σ (d(½ voxel on along axis i) - d(½ voxel back))², √Σ spacing_i²)
//
// and the greatest of all of these counts. w is how much d changes across a voxel: one spacing, where the surface is
// square to its axis. So the surface is the coverage's ½ level, and has no steps even with a hard rim: the rim spans
// the two voxels between which the level is interpolated. A voxel's value becomes the mix of its own and of air
// (ShownVoxels); a voxel whose coverage is above ½ leaves the focus and has no label.

#include <cstdint>
#include <memory>
#include <vector>

#include "rendering/settings/Removal.h"
#include "rendering/volume/Grid.h"

namespace fenestra {

/// Whether a removal can remove something: its numbers are finite and in their ranges, and it has a point.
bool removesAnything(const Removal& removal);

/// The plane that a stroke spans: through the mean of its points, with the two principal axes along which they spread
/// most. Where they lie on a line (their standard deviation along the second axis is below a twentieth of that along
/// the first), or in one place, the plane is that whose normal is nearest to `towards`.
struct StrokePlane {
  StrokePlane(const std::vector<glm::dvec3>& points, glm::dvec3 towards);
  glm::dvec3 centre, first, second;  ///< world; axes are unit vectors, square to each other
  glm::dvec3 normal;                 ///< unit; not against `towards`
};

/// The height of a bent plane above the unbent one, along its normal.
class BentPlane {
 public:
  BentPlane(const StrokePlane& plane, const std::vector<Bend>& bends);
  struct Height {
    double value = 0.0;        ///< mm
    glm::dvec2 gradient{0.0};  ///< by the place
  };
  /// At a place of the plane: mm along its axes from the centre.
  Height at(glm::dvec2 place) const;
  glm::dvec2 placeOf(glm::dvec3 world) const;
  const StrokePlane& plane() const { return plane_; }

 private:
  struct Drag {
    glm::dvec2 place;
    double height;  ///< there, before the drag
    double distance, radius;
  };
  void apply(const Drag& drag, glm::dvec2 place, Height& height) const;

  StrokePlane plane_;
  std::vector<Drag> drags_;
};

/// Coverages of the voxels of a box of a grid; beyond it nothing is removed.
struct RemovedVoxels {
  glm::ivec3 low{0}, size{0};          ///< voxels
  std::vector<std::uint8_t> coverage;  ///< of 255, x fastest
  std::vector<Removal> parts;          ///< that it was made of: one line, box or plane each
  Grid grid;

  std::uint8_t at(glm::ivec3 voxel) const {
    const glm::ivec3 in = voxel - low;
    if (glm::any(glm::lessThan(in, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(in, size))) return 0;
    return coverage[offset(in)];
  }
  /// Calls use(x, coverage) for those voxels of a row of the grid of which something is removed, in order.
  template <class F>
  void forEachIn(int y, int z, F&& use) const {
    const glm::ivec3 in = glm::ivec3(low.x, y, z) - low;
    if (in.y < 0 || in.z < 0 || in.y >= size.y || in.z >= size.z) return;
    const std::uint8_t* row = coverage.data() + offset(in);
    for (int x = 0; x < size.x; ++x)
      if (row[x] > 0) use(low.x + x, row[x]);
  }
  /// Whether a voxel of that coverage leaves the focus.
  static constexpr bool isGone(std::uint8_t coverage) { return coverage > 127; }

 private:
  std::size_t offset(glm::ivec3 in) const {
    return static_cast<std::size_t>(in.x) +
           static_cast<std::size_t>(size.x) *
               (static_cast<std::size_t>(in.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(in.z));
  }
  friend class Coverer;
};

/// Null where nothing of the grid is removed. `before`, of an earlier list or null, saves work where that list is the
/// beginning of this one. Runs on all cores.
std::shared_ptr<const RemovedVoxels> removedVoxels(const Removals& removals, const Grid& grid,
                                                   const std::shared_ptr<const RemovedVoxels>& before = nullptr);

}  // namespace fenestra
