#pragma once
// Where the slices of a stack lie, what is odd about that, and how far they are from where a grid shows them. Geometry
// alone. World is LPS mm.

#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomStack.h"

namespace fenestra::io {

/// Positions are compared to this many mm.
constexpr double positionTolerance = GeometryReport::tolerance;

/// The slices' places in the frame of the first one.
struct SliceLayout {
  glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit, from the first slice to the last
  /// The slices' first pixels from the first slice's: in pixels along its rows (x) and columns (y), and in mm along the
  /// normal (z), ascending.
  std::vector<glm::dvec3> offsets;
  /// The distance of neighbouring slices that the series was made with, mm along the normal: the median, or the least
  /// one where it is the unit of all others (missing slices), or the one that more than a tenth of the slices keep to
  /// where that is much less.
  double ownStep = 0.0;
  std::size_t missing = 0;    ///< slices that would fill the gaps, where all gaps are multiples of ownStep
  double displacement = 0.0;  ///< mm, the farthest of a slice's position from where the stack's grid has it
  /// mm, the farthest of a pixel from where it lies when its slice has the directions and spacing of the first slice.
  double turned = 0.0;
};
/// `stack` has at least two slices with geometry.
SliceLayout layoutOf(const DicomStack& stack);

/// Distances of neighbouring slices, mm along the normal.
std::vector<double> gapsOf(const SliceLayout& layout);
double median(std::vector<double> values);

/// What is odd about a layout, one finding each: tilt, missing slices or uneven spacing, sideways shifts, directions
/// that differ. Empty below positionTolerance.
std::vector<Warning> findingsOf(const DicomStack& stack, const SliceLayout& layout,
                                const std::vector<DicomFile>& files);

/// "4.002 mm"
std::string millimetres(double value);
/// "1 slice", "2 slices"
std::string counted(std::size_t count, const char* noun);
/// The files of frames, each once.
std::vector<std::filesystem::path> pathsOf(const std::vector<DicomFrame>& frames, const std::vector<DicomFile>& files);

}  // namespace fenestra::io
