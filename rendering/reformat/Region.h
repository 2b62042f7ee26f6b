#pragma once
// A region of voxels, and what a plane across a curve cuts out of it.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rendering/reformat/PathCurve.h"
#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra::reformat {

/// Voxels in the least box that holds them, with a border of others where the label map goes on.
struct VoxelRegion {
  Grid grid;                         ///< of the box
  glm::dmat3 toIndex{1.0};           ///< voxels from mm, of grid
  std::vector<std::uint8_t> inside;  ///< 1 or 0, x fastest

  bool isEmpty() const { return inside.empty(); }
  /// The trilinear field of the voxels at a point of the patient, 0 outside the label map. The surface is where it is
  /// ½.
  double at(glm::dvec3 point) const;
};

/// The largest 26-connected part of the voxels with one of `values`; among equal ones the first in memory. Empty where
/// there are none. Can be stopped (Interruptible).
VoxelRegion regionOf(const LabelMap& labels, std::span<const std::uint16_t> values);

/// The part of a region's cross-section that is connected with its place of a curve.
struct Section {
  double area = 0.0;       ///< mm²
  glm::dvec3 centre{0.0};  ///< of the area, mm

  double radius() const;  ///< mm, of the circle of that area
};

/// In the plane across the curve at `place`, where that lies in the region or within `reach` mm of it; empty
/// otherwise. Counted in squares of a quarter of the least voxel's side.
std::optional<Section> sectionOf(const VoxelRegion& region, const PathPlace& place, double reach);

}  // namespace fenestra::reformat
