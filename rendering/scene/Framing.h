#pragma once
// What a camera is to have in its picture.

#include <vector>

#include "rendering/scene/Grid.h"

namespace fenestra {

struct ShownVolume;
struct TransferFunction;

/// Points that enclose what is to be seen, and the point that a camera turns around.
struct Framing {
  glm::dvec3 centre{0.0};          ///< world, mm
  std::vector<glm::dvec3> points;  ///< world, mm; what is to be seen lies in their convex hull

  /// All of a grid.
  Framing(const Grid& grid);  // NOLINT(google-explicit-constructor): a camera frames a grid as readily
  Framing(glm::dvec3 around, std::vector<glm::dvec3> hull) : centre(around), points(std::move(hull)) {}

  /// mm from the centre to the farthest point.
  double radius() const;
};

/// The part of the volume's grid that `context` shows, for a camera to frame: scans hold much air. Nearly empty slabs
/// of voxels (a table's edge, noise) do not count. The whole grid when the context shows nothing.
Grid visibleGrid(const ShownVolume& shown, const TransferFunction& context);

/// What `context` shows of a volume: the hull of the blocks of voxels that show in part, within visibleGrid() and
/// around its centre. Tighter than that box, whose corners are air around a head.
Framing visibleFraming(const ShownVolume& shown, const TransferFunction& context);

}  // namespace fenestra
