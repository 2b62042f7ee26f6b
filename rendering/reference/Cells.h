#pragma once
// Walks a ray cell by cell. Inside a cell the trilinear field along the ray is a cubic, so its crossings of a level are
// found without stepping.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

/// A part of a ray inside one cell: t at both ends, and the position in the cell, 0..1 between its corners.
struct Piece {
  glm::ivec3 cell{0};
  double tBegin = 0.0, tEnd = 0.0;
  glm::dvec3 begin{0.0}, end{0.0};
};

/// Calls visit(piece) for the cells along `ray` (index space) in order, until it returns false. Cell c spans index
/// c … c+1; the outermost ones reach half a voxel beyond the outermost centres.
template <class Visit>
void walkCells(const Ray& ray, Span span, glm::ivec3 dims, Visit&& visit) {
  const auto at = [&](double t) { return ray.origin + t * ray.direction; };
  glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(at(span.tIn))), glm::ivec3(-1), dims - 1);
  double t = span.tIn;
  while (true) {
    // Each plane's t comes from the plane itself, so that no error adds up on the way.
    double tNext = std::numeric_limits<double>::infinity();
    int exitAxis = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const double direction = ray.direction[axis];
      if (direction == 0.0) continue;
      const double plane = direction > 0.0 ? cell[axis] + 1.0 : cell[axis];
      const double tPlane = (plane - ray.origin[axis]) / direction;
      if (tPlane < tNext) {
        tNext = tPlane;
        exitAxis = axis;
      }
    }
    const bool last = !(tNext < span.tOut);
    const double tEnd = std::max(t, last ? span.tOut : tNext);
    if (!visit(Piece{cell, t, tEnd, at(t) - glm::dvec3(cell), at(tEnd) - glm::dvec3(cell)}) || last) return;
    t = tEnd;
    cell[exitAxis] += ray.direction[exitAxis] > 0.0 ? 1 : -1;
    if (cell[exitAxis] < -1 || cell[exitAxis] >= dims[exitAxis]) return;
  }
}

/// Values at a cell's corners; corner i lies at (i & 1, (i >> 1) & 1, i >> 2).
using Corners = std::array<double, 8>;

/// valueAt(index) at the corners of `cell`, clamped to the grid.
template <class ValueAt>
Corners cornersOf(glm::ivec3 cell, glm::ivec3 dims, const ValueAt& valueAt) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 corner = cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
    corners[static_cast<std::size_t>(i)] = valueAt(glm::clamp(corner, glm::ivec3(0), dims - 1));
  }
  return corners;
}

/// Trilinear interpolation between eight corners of any vector type, `at` in 0..1.
template <class T>
T interpolate(const std::array<T, 8>& corners, glm::dvec3 at) {
  const auto mix = [](const T& a, const T& b, double w) { return a * (1.0 - w) + b * w; };
  const auto row = [&](std::size_t i) { return mix(corners[i], corners[i + 1], at.x); };
  return mix(mix(row(0), row(2), at.y), mix(row(4), row(6), at.y), at.z);
}

/// c0 + c1·s + c2·s² + c3·s³; the trilinear field along a piece, s from 0 to 1.
using Cubic = std::array<double, 4>;

inline double evaluate(const Cubic& c, double s) { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }

Cubic alongPiece(const Corners& corners, const Piece& piece);

/// The cubic through values at 0, 1/3, 2/3 and 1.
Cubic through(double a, double b, double c, double d);

/// 0, the places in (0, 1) where the cubic's slope changes sign, and 1; the cubic is monotone between neighbours.
struct Stops {
  std::array<double, 4> s{};
  std::size_t count = 0;
};
Stops monotoneStops(const Cubic& cubic);

/// The least double in (inside, outside] at which left(s) holds, for a condition that fails at `inside`, holds at
/// `outside` and changes once.
template <class Left>
double bisect(double inside, double outside, const Left& left) {
  while (true) {
    const double middle = 0.5 * (inside + outside);
    if (!(inside < middle && middle < outside)) return outside;
    (left(middle) ? outside : inside) = middle;
  }
}

/// Appends the places in (0, 1) where the cubic crosses `level`.
void appendCrossings(const Cubic& cubic, const Stops& stops, double level, std::vector<double>& places);

}  // namespace fenestra::reference
