#pragma once
// Slices across a volume in any direction: parallel planes with a common normal, in square pixels.

#include <optional>

#include "rendering/volume/Grid.h"
#include "rendering/volume/Slice.h"

namespace fenestra {

/// The directions of a picture plane in the patient: unit vectors in LPS, each perpendicular to the others. Sagittal
/// pictures are left-handed (see Slice.h), so the normal does not follow from the other two.
struct PlaneAxes {
  glm::dvec3 right{1.0, 0.0, 0.0}, down{0.0, 1.0, 0.0}, normal{0.0, 0.0, 1.0};
  bool operator==(const PlaneAxes&) const = default;
};

/// Whether they are what the struct says, to what six digits give.
bool isPerpendicular(const PlaneAxes& axes);

/// The directions of an anatomical plane's slices through the volume, those of a sheared grid made perpendicular.
PlaneAxes planeAxes(const Grid& grid, SlicePlane plane);

/// Length in mm that crosses one voxel along `direction` (a unit vector): the spacing, for a direction of the grid.
double voxelLength(const Grid& grid, glm::dvec3 direction);

/// Planes along `axes.normal` that cover the whole box of the volume, one voxelLength() of the normal apart. A pixel's
/// centre of one of the planes lies on `through` (LPS, mm), which may lie outside the volume. `pixel` is the side of a
/// pixel in mm; without it, the smaller voxelLength() of the picture's directions, and no side of more than about 4096
/// pixels. SliceGeometry::axis is -1: the planes follow no axis of the grid. `plane` is what they were turned from.
SliceGeometry obliqueGeometry(const Grid& grid, SlicePlane plane, const PlaneAxes& axes, glm::dvec3 through,
                              std::optional<double> pixel = {});

/// The anatomical plane whose slices a direction (not zero) is most nearly perpendicular to.
SlicePlane nearestPlane(const Grid& grid, glm::dvec3 normal);

/// Axes of the planes perpendicular to `normal` (not zero), seen as those of nearestPlane() are: the picture's down is
/// theirs, projected onto the plane, and its handedness theirs, so that the normal's sign has no effect.
PlaneAxes planeAxes(const Grid& grid, glm::dvec3 normal);

/// One slice of so many square pixels of `pixel` mm, in the middle of which `centre` (LPS, mm) lies.
SliceGeometry sliceAround(SlicePlane plane, const PlaneAxes& axes, glm::dvec3 centre, glm::ivec2 size, double pixel);

}  // namespace fenestra
