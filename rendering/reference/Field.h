#pragma once
// The volume's values along a ray, as cubics.
//
// Trilinear values are one cubic a cell. Along a straight line through a cell a tricubic spline is a polynomial of
// degree 9: it is cut into `piecesPerCell` pieces, and in each the cubic through four of its values stands for it. That
// cubic's error is at most h⁴/24 of the greatest fourth derivative, h a third of a piece: with derivatives by the
// length of the line in the cell, 1.3e-7 of it.

#include <optional>

#include "rendering/reference/Cells.h"
#include "rendering/scene/SplineVolume.h"

namespace fenestra::reference {

/// A part of a cell's piece of a ray, along which values are one cubic, s from 0 to 1.
struct FieldPiece {
  Piece piece;
  Cubic value{};
  ValueRange range;  ///< that the cubic keeps to
};

class Field {
 public:
  static constexpr int piecesPerCell = 8;

  explicit Field(const Scene& scene);

  /// The part of a piece between two shares of its way.
  static Piece partOf(const Piece& piece, double from, double to);

  /// Null where the values are trilinear.
  const SplineVolume* spline() const { return spline_ ? &*spline_ : nullptr; }

  /// The value at a continuous index position. `valueAt` is that of withValues().
  template <class ValueAt>
  double value(glm::dvec3 index, const ValueAt& valueAt) const {
    if (spline_) return spline_->value(index);
    const glm::ivec3 cell(glm::floor(index));
    return interpolate(cornersOf(cell, dims_, valueAt), index - glm::dvec3(cell));
  }

  /// Calls visit(FieldPiece) for the parts of a piece in order, until it returns false; returns what it returned last.
  /// Visits none where wants(range of the values in the cell) is false.
  template <class ValueAt, class Wants, class Visit>
  bool along(const Piece& piece, const ValueAt& valueAt, Wants&& wants, Visit&& visit) const {
    if (spline_) return !wants(spline_->range(piece.cell)) || alongSpline(piece, visit);
    const Corners corners = cornersOf(piece.cell, dims_, valueAt);
    const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
    const ValueRange range{*least, *greatest};
    return !wants(range) || visit(FieldPiece{piece, alongPiece(corners, piece), range});
  }

 private:
  template <class Visit>
  bool alongSpline(const Piece& piece, Visit&& visit) const {
    double before = valueIn(piece, 0.0);
    for (int i = 0; i < piecesPerCell; ++i) {
      const double from = static_cast<double>(i) / piecesPerCell, to = static_cast<double>(i + 1) / piecesPerCell;
      const double after = valueIn(piece, to);
      const Cubic value = through(before, valueIn(piece, glm::mix(from, to, 1.0 / 3.0)),
                                  valueIn(piece, glm::mix(from, to, 2.0 / 3.0)), after);
      if (!visit(FieldPiece{partOf(piece, from, to), value, rangeOf(value)})) return false;
      before = after;
    }
    return true;
  }

  double valueIn(const Piece& piece, double s) const {
    return spline_->value(glm::dvec3(piece.cell) + glm::mix(piece.begin, piece.end, s));
  }
  static ValueRange rangeOf(const Cubic& cubic);

  glm::ivec3 dims_;
  std::optional<SplineVolume> spline_;
};

}  // namespace fenestra::reference
