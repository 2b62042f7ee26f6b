#include "rendering/reference/Field.h"

namespace fenestra::reference {

Field::Field(const Scene& scene) : dims_(scene.volume->grid.dims) {
  const ShownVolume shown = shownVolume(scene);
  if (shown.reconstruction != Reconstruction::Linear) spline_.emplace(shown);
}

Piece Field::partOf(const Piece& piece, double from, double to) {
  const auto t = [&](double s) { return s == 1.0 ? piece.tEnd : piece.tBegin + s * (piece.tEnd - piece.tBegin); };
  return {piece.cell, t(from), t(to), glm::mix(piece.begin, piece.end, from), glm::mix(piece.begin, piece.end, to)};
}

ValueRange Field::rangeOf(const Cubic& cubic) {
  // The hull of its Bernstein coefficients.
  const std::array<double, 4> b{cubic[0], cubic[0] + cubic[1] / 3.0, cubic[0] + (2.0 * cubic[1] + cubic[2]) / 3.0,
                                cubic[0] + cubic[1] + cubic[2] + cubic[3]};
  const auto [least, greatest] = std::minmax_element(b.begin(), b.end());
  return {*least, *greatest};
}

}  // namespace fenestra::reference
