#include "rendering/settings/FlatStack.h"

#include <algorithm>

namespace fenestra {
namespace {

constexpr double flatShare = 0.125, solidShare = 1.0 / 3.0;
constexpr double fewSlices = 3.0, manySlices = 6.0;
/// A stack of few slices has at least this many times as many rows and columns: a small cube is none.
constexpr int leastAcross = 4;
/// An extent of 0.23 of the next one: from there on, a view edge-on has less than a quarter of the front's picture.
constexpr double leastFlatness = 0.25;

/// 1 up to `from`, 0 beyond `to`.
double falling(double value, double from, double to) { return std::clamp((to - value) / (to - from), 0.0, 1.0); }

}  // namespace

FlatStack flatStack(const CropFrame& frame, const Grid& grid) {
  FlatStack stack;
  const glm::dvec3 extent = frame.high - frame.low;
  const glm::ivec3 counts(grid.dims[frame.axis[0]], grid.dims[frame.axis[1]], grid.dims[frame.axis[2]]);
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    double thinness = falling(extent[axis] / std::min(extent[second], extent[third]), flatShare, solidShare);
    if (leastAcross * counts[axis] <= std::min(counts[second], counts[third]))
      thinness = std::max(thinness, falling(counts[axis], fewSlices, manySlices));
    if (thinness * thinness <= stack.flatness) continue;
    stack.flatness = thinness * thinness;
    // Towards L, A and I.
    stack.front = (axis == 0 ? 1.0 : -1.0) * frame.normal[static_cast<std::size_t>(axis)];
  }
  return stack;
}

Camera firstCamera(const Grid& grid, const Framing& framing, Projection projection) {
  const FlatStack stack = flatStack(CropFrame(grid), grid);
  return stack.flatness < leastFlatness ? Camera::standard(StandardView::Anterior, framing, projection)
                                        : Camera::fromDirection(stack.front, framing, projection);
}

Camera secondCamera(const Camera& first, const Grid& grid) {
  const CropFrame frame(grid);
  const FlatStack stack = flatStack(frame, grid);
  const glm::dvec3 towardsEye = -first.axes().forward;
  constexpr double straight = 0.99;  // a camera that was turned by hand has its partner beside it
  if (stack.flatness < leastFlatness || glm::dot(towardsEye, stack.front) < straight) return first.beside();
  const glm::dvec3 anterior = -frame.normal[1];
  const glm::dvec3 aside = stack.front == anterior ? frame.normal[0] : anterior;
  const glm::dvec3 direction = glm::normalize(towardsEye + aside);
  Camera camera = first;
  camera.eye = first.target + glm::length(first.eye - first.target) * direction;
  camera.up = uprightFrom(direction);
  return camera;
}

}  // namespace fenestra
