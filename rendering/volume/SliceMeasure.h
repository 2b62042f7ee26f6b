#pragma once
// Distances, angles and regions of interest drawn on a slice, and marks, which are arrows and texts: where they lie in
// the patient, and what they measure. Marks measure nothing.

#include <optional>
#include <string>
#include <vector>

#include "rendering/volume/Slice.h"

namespace fenestra {

enum class MeasureKind : std::uint8_t { Distance, Angle, Ellipse, Rectangle, Arrow, Text };

/// World (LPS), mm. `right` and `down` are the unit vectors of the slice's rows and columns: with the points they say
/// which plane the measure lies on.
struct Measure {
  MeasureKind kind = MeasureKind::Distance;
  /// Distance: its ends. Angle: end, vertex, end. Ellipse and Rectangle: opposite corners of the box around it, whose
  /// sides run along `right` and `down`. Arrow: its tip, and its end, where the text stands. Text: where it begins.
  std::vector<glm::dvec3> points;
  glm::dvec3 right{1.0, 0.0, 0.0}, down{0.0, 1.0, 0.0};
  /// A mark's words, UTF-8 on one line, at most longestText bytes; those of a Text are not empty.
  std::string text = {};
  static constexpr std::size_t longestText = 400;

  bool operator==(const Measure&) const = default;
};

/// How many points a measure of a kind has.
std::size_t pointCount(MeasureKind kind);
inline bool isRegion(MeasureKind kind) { return kind == MeasureKind::Ellipse || kind == MeasureKind::Rectangle; }
inline bool isMark(MeasureKind kind) { return kind == MeasureKind::Arrow || kind == MeasureKind::Text; }
/// Whether a measure has the points, the plane and the text that its kind needs.
bool isWellFormed(const Measure& measure);

/// The slice of a plane that a measure lies on: the nearest one, where the planes are parallel and the measure lies
/// within half a slice of it. Empty for other planes and beyond the volume.
std::optional<int> sliceOf(const Measure& measure, const SliceGeometry& geometry);

/// Real values at the pixel centres inside a region of interest, each pixel once.
struct RegionValues {
  std::size_t count = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< of the sample, with count - 1; 0 for one pixel
  double least = 0.0, greatest = 0.0;
};

/// What a measure says. Only the members of its kind are there.
struct MeasureValues {
  std::optional<double> length;  ///< mm
  std::optional<double> angle;   ///< degrees, 0 to 180
  std::optional<double> area;    ///< mm², of the drawn shape
  /// Empty where no pixel centre of the volume lies inside.
  std::optional<RegionValues> region;
};
/// Lengths and angles come from the points alone. A region's values are those of the slice that it lies on, as
/// sliceValues() gives them; on a turned plane, those of obliqueGeometry()'s pixels through its first point. Pixels
/// without a value do not count.
MeasureValues valuesOf(const Measure& measure, const Volume& volume);

/// Where a measure can be grabbed: its points; a rectangle's four corners, the ends of an ellipse's axes.
std::vector<glm::dvec3> handlesOf(const Measure& measure);
/// The measure with a handle moved to a point of its plane.
Measure withHandleAt(Measure measure, std::size_t handle, glm::dvec3 world);
/// The measure moved as a whole.
Measure movedBy(Measure measure, glm::dvec3 offset);

}  // namespace fenestra
