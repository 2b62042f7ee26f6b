#pragma once
// Slices of an irregular series on even planes: right geometry for slices that are missing, unevenly spaced or stacked
// askew.
//
// The planes are parallel to the slices, evenly spaced from the first slice to the last at about the series' own step
// (SliceLayout::ownStep). They lie straight behind each other along the normal, or, in a sheared stack, on the line
// from the first slice to the last: then slices on that line need no interpolation between their pixels. The slices'
// grid of pixels is kept and grows by whole pixels where slices lie beside the planes' column.
//
// A voxel's value is interpolated from the slices at their true positions, so no structure is displaced. From slice to
// slice, in the direction that the planes are stacked in: linear, or piecewise cubic (Hermite; the slope at a slice is
// that of the parabola through it and its neighbours, that at the ends of the line through the last two). Within a
// slice that is shifted by a part of a pixel: bilinear, or the cubic convolution of Keys (IEEE Trans. ASSP 29, 1981, a
// = -1/2). Cubic values are clamped to the slices' range.
//
// Gaps are interpolated however wide they are: what lies between two slices is unknown in a narrow gap, too, and an
// empty gap would look like a cut through the patient. The report lists planes in gaps wider than one and a half of
// the own steps. Slices beyond gaps of more than ten steps are volumes of their own (DicomStack.h). A voxel next to
// whose place one of the two neighbouring slices has no pixel was not scanned and holds the volume's least value.

#include <cstddef>
#include <functional>

#include "io/dicom/SliceLayout.h"

namespace fenestra::io {

/// The planes of a stack.
class RegularStack {
 public:
  enum class Shape : std::uint8_t { Straight, Sheared };
  enum class Interpolation : std::uint8_t { Linear, Cubic };
  RegularStack(const DicomStack& stack, const SliceLayout& layout, Shape shape, Interpolation interpolation);

  const Grid& grid() const { return grid_; }
  /// Planes inside gaps wider than one and a half of the series' own steps.
  const std::vector<int>& interpolatedPlanes() const { return interpolatedPlanes_; }

  struct Result {
    Voxels voxels;
    std::size_t empty = 0;  ///< voxels outside of what was scanned
  };
  /// `slices` are the voxels of the stack's own grid, one slice after the other. The result has the same type.
  /// `lowest` says whether the least stored value stands for the least real one (a slope above zero). Calls `step`
  /// before each plane, from many threads; what it throws ends the work.
  Result resample(const Voxels& slices, bool lowest, const std::function<void()>& step) const;

 private:
  /// A slice that a plane takes values from.
  struct Source {
    std::size_t slice = 0;
    double weight = 0.0;
  };
  /// The slices beside a plane, and all that its values come from. The first are among the second.
  struct Plane {
    std::vector<Source> linear, all;
  };
  /// Grows the grid by whole pixels until it holds every slice.
  void growOverSlices();
  Plane planeAt(double height) const;
  void addPlanes(double step);

  bool cubic_;
  glm::ivec3 slicesDims_;
  glm::dvec2 spacing_;
  Grid grid_;
  double ownStep_;
  std::vector<double> heights_;     ///< of the slices, mm along the normal
  std::vector<glm::dvec2> shifts_;  ///< of the planes' first pixel from each slice's, in pixels
  std::vector<Plane> planes_;
  std::vector<int> interpolatedPlanes_;
};

}  // namespace fenestra::io
