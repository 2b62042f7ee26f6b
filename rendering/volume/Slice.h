#pragma once
// Axial, sagittal and coronal slices on the CPU, which work without OpenGL.
//
// A slice follows the volume's own index planes (the plane whose axis is nearest to the anatomical one), so that an
// oblique acquisition shows its pixels as acquired; sheared grids are resampled into an orthogonal picture plane.
// Radiological convention: axial and coronal show the patient's right on the left of the picture; sagittal shows
// anterior on the left.

#include <string>
#include <vector>

#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

enum class SlicePlane : std::uint8_t { Axial, Sagittal, Coronal };

/// Where the pixels of a plane's slices lie. Pixel (i, j), j from the top, of slice k is at world
/// origin + i·right + j·down + k·normal (vectors in mm per step).
struct SliceGeometry {
  SlicePlane plane = SlicePlane::Axial;
  int axis = 2;               ///< the index axis that counts slices
  int count = 0;              ///< number of slices
  int width = 0, height = 0;  ///< pixels
  glm::dvec3 origin{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 down{0.0, 1.0, 0.0};
  glm::dvec3 normal{0.0, 0.0,
                    1.0};  ///< points towards S (axial), L (sagittal) or P (coronal): slice numbers grow that way

  glm::dvec3 worldFromPixel(double i, double j, double slice) const;
  /// (i, j, slice), continuous.
  glm::dvec3 pixelFromWorld(glm::dvec3 world) const;
  /// Nearest slice to a patient coordinate in mm along the plane's anatomical axis (S, L or P), measured at the centre
  /// of the slice; clamped to the volume.
  int sliceAt(double mm) const;
};

SliceGeometry sliceGeometry(const Grid& grid, SlicePlane plane);

/// Real values of a slice, row by row from the top, width·height of them; NaN outside the volume.
std::vector<float> sliceValues(const Volume& volume, const SliceGeometry& geometry, int slice);
/// Reads the values of a slice one by one, in double precision. The volume must outlive this.
class SliceSampler {
 public:
  SliceSampler(const Volume& volume, const SliceGeometry& geometry, int slice);
  /// At a pixel's centre; NaN outside the volume.
  double at(int i, int j) const;

 private:
  const Volume& volume_;
  glm::dvec3 start_, right_, down_;  ///< index positions of the first pixel, and steps
  bool onVoxels_;
};
/// Labels of a slice by nearest voxel, 0 outside.
std::vector<std::uint16_t> sliceLabels(const LabelMap& labels, const SliceGeometry& geometry, int slice);
/// 8-bit grey of real values under a window; `lowIsWhite` turns it round. NaN is black in either case.
std::vector<std::uint8_t> windowed(const std::vector<float>& values, WindowLevel window, bool lowIsWhite = false);

/// Patient letters of a world direction (LPS), e.g. "L", or "PR" for an oblique one: the axes whose component exceeds a
/// quarter of the largest, largest first (the lettering of DICOM PS3.3 C.7.6.1.1.1).
std::string orientationLetters(glm::dvec3 direction);

}  // namespace fenestra
