#pragma once
// Where a grid of voxels lies in the patient, and the coordinate frames of the whole project.
//
// Frames (a transform is named bFromA):
//   world    patient frame, LPS, mm (DICOM PS3.3 C.7.6.2.1.1)
//   index    continuous voxel index; voxel centres on integers, the grid's box is [-½, dims-½] on each axis
//   view     eye at the origin, looking along -z, y up, mm
//   clip     OpenGL clip space
//   pixel    (i, j) from the top left of the picture, pixel centres on integers + ½

#include <array>
#include <cstddef>

#include <glm/glm.hpp>

namespace fenestra {

inline constexpr double mm3PerMl = 1000.0;

/// A regular lattice in world space. `direction`'s columns are the unit vectors of the index axes; they need not be
/// orthogonal (a gantry-tilted series is a sheared lattice) nor right-handed.
struct Grid {
  glm::ivec3 dims{0};
  glm::dvec3 spacing{1.0};    ///< mm between neighbouring voxel centres along each index axis, > 0
  glm::dvec3 origin{0.0};     ///< world position of the centre of voxel (0,0,0), mm
  glm::dmat3 direction{1.0};  ///< world from index axes, unit columns

  std::size_t voxelCount() const;
  glm::dmat4 worldFromIndex() const;
  glm::dmat4 indexFromWorld() const;
  /// Volume of one voxel in mm³ (the lattice's determinant, so it holds for sheared grids).
  double voxelVolume() const;
  /// World position of the centre of the grid's box.
  glm::dvec3 centre() const;
  /// The eight world corners of the grid's box (voxel extents, not voxel centres).
  std::array<glm::dvec3, 8> corners() const;
  /// Radius in mm of the sphere around centre() through the box's farthest corner.
  double boundingRadius() const;
  bool contains(glm::ivec3 index) const;
  /// The index axis that runs along each of the patient's axes L, P and S: of the six assignments the one with the
  /// largest product of cosines, which is never zero for a lattice of full rank, so that each gets an axis that moves
  /// along it.
  glm::ivec3 patientAxes() const;
  /// Position of voxel `index` in a linear array, x fastest.
  std::size_t offset(glm::ivec3 index) const;

  bool operator==(const Grid&) const = default;
};

}  // namespace fenestra
