#pragma once
// Closed polygons on one plane, filled by the even-odd rule: which stretches of a line across the plane lie inside.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::io {

/// Polygons on a plane with coordinates (u, v) in mm. Every second crossing of a line v = const enters or leaves
/// (even-odd rule), so that a contour within another is a hole and a third one within that an island. Points on a
/// contour belong to the structure: contours traced through the centres of border pixels give those pixels back.
class ContourFill {
 public:
  /// A stretch of u, ends included.
  struct Stretch {
    double begin = 0.0, end = 0.0;
  };

  /// `tolerance` in mm is how far coordinates may be off by their rounding: so much outside still counts as on the
  /// contour.
  explicit ContourFill(double tolerance) : tolerance_(tolerance) {}

  /// At least three points; the last is joined to the first.
  void add(std::span<const glm::dvec2> polygon);
  /// Sorts the edges by v; call once, after the last polygon.
  void finish();
  /// The stretches inside along `v`, ascending and disjoint. `into` is replaced.
  void stretches(double v, std::vector<Stretch>& into) const;
  /// Edges that a line has to look at, on average; what stretches() costs.
  double edgesPerLine() const;

 private:
  struct Edge {
    glm::dvec2 from, to;
  };
  std::size_t bandOf(double v) const;

  double tolerance_;
  std::vector<Edge> edges_;
  double low_ = 0.0, bandHeight_ = 1.0;
  std::vector<std::size_t> starts_;  ///< of each band in `members_`, and the end
  std::vector<std::size_t> members_;
};

}  // namespace fenestra::io
