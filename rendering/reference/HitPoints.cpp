#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rendering/reference/FocusCells.h"
#include "rendering/reference/Reference.h"
#include "rendering/scene/Parallel.h"

namespace fenestra::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A closed set of values, told by the open gaps outside it. A ray that is in a gap enters the set through one of that
/// gap's two ends and no other value.
using Gaps = std::vector<ValueGap>;

const ValueGap* gapAround(const Gaps& gaps, double value) {
  for (const ValueGap& gap : gaps)
    if (gap.low < value && value < gap.high) return &gap;
  return nullptr;
}

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
    double tNext = infinity;
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

/// The trilinear field along a piece, s from 0 to 1: c0 + c1·s + c2·s² + c3·s³.
using Cubic = std::array<double, 4>;

double evaluate(const Cubic& c, double s) { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }

/// a + (b - a)·(w0 + dw·s); a and b of at most second degree.
Cubic mix(const Cubic& a, const Cubic& b, double w0, double dw) {
  Cubic result = a;
  for (std::size_t k = 0; k < 4; ++k) {
    result[k] += (b[k] - a[k]) * w0;
    if (k > 0) result[k] += (b[k - 1] - a[k - 1]) * dw;
  }
  return result;
}

/// Corner i lies at (i & 1, (i >> 1) & 1, i >> 2).
using Corners = std::array<double, 8>;

Cubic alongPiece(const Corners& corners, const Piece& piece) {
  const glm::dvec3 w = piece.begin, dw = piece.end - piece.begin;
  const auto edge = [&](std::size_t i) { return mix({corners[i]}, {corners[i + 1]}, w.x, dw.x); };
  const Cubic front = mix(edge(0), edge(2), w.y, dw.y), back = mix(edge(4), edge(6), w.y, dw.y);
  return mix(front, back, w.z, dw.z);
}

/// 0, the places in (0, 1) where the cubic's slope changes sign, and 1: it is monotone between neighbours.
struct Stops {
  std::array<double, 4> s{};
  std::size_t count = 0;
};

Stops monotoneStops(const Cubic& cubic) {
  Stops stops;
  stops.s[stops.count++] = 0.0;
  // The quadratic's roots in the form that does not cancel (Press et al., Numerical Recipes, §5.6).
  const double a = 3.0 * cubic[3], b = 2.0 * cubic[2], c = cubic[1];
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant > 0.0) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const double first = std::min(q / a, c / q), second = std::max(q / a, c / q);
    for (const double root : {first, second})
      if (root > 0.0 && root < 1.0) stops.s[stops.count++] = root;
  }
  stops.s[stops.count++] = 1.0;
  return stops;
}

/// First t of the piece whose value lies in none of the gaps.
std::optional<double> firstOutside(const Gaps& gaps, const Corners& corners, const Piece& piece) {
  const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end());
  for (const ValueGap& gap : gaps)
    if (gap.low < *least && *greatest < gap.high) return {};

  const Cubic cubic = alongPiece(corners, piece);
  const ValueGap* gap = gapAround(gaps, cubic[0]);
  if (!gap) return piece.tBegin;
  const auto left = [&](double s) {
    const double value = evaluate(cubic, s);
    return value <= gap->low || value >= gap->high;
  };
  const Stops stops = monotoneStops(cubic);
  for (std::size_t k = 0; k + 1 < stops.count; ++k) {
    double inside = stops.s[k], outside = stops.s[k + 1];
    if (!left(outside)) continue;
    // Monotone between the two: halve until the doubles are neighbours.
    while (true) {
      const double middle = 0.5 * (inside + outside);
      if (!(inside < middle && middle < outside)) break;
      (left(middle) ? outside : inside) = middle;
    }
    return piece.tBegin + outside * (piece.tEnd - piece.tBegin);
  }
  return {};
}

template <class ValueAt>
Corners cornersOf(glm::ivec3 cell, glm::ivec3 dims, const ValueAt& valueAt) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 corner = cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
    corners[static_cast<std::size_t>(i)] = valueAt(glm::clamp(corner, glm::ivec3(0), dims - 1));
  }
  return corners;
}

/// First t of a ray in the context or the focus, and in the focus.
struct Hit {
  double tContext = nothing, tFocus = nothing;
};

/// Runs f(focusIn), where focusIn(piece, its cell's corner values) is the first t of the focus in a piece, if any.
template <class F>
void withFocus(const Scene& scene, F&& f) {
  const glm::ivec3 dims = scene.volume->grid.dims;
  if (const auto* focus = std::get_if<LabelFocus>(&scene.focus); focus && scene.labels) {
    std::vector<double> indicator(std::numeric_limits<std::uint16_t>::max() + 1, 0.0);
    for (const std::uint16_t label : focus->labels) indicator[label] = 1.0;
    const Gaps outside{{-infinity, 0.5}};
    scene.labels->voxels.visit([&](auto voxels) {
      f([&](const Piece& piece, const Corners&) {
        const auto indicatorAt = [&](glm::ivec3 index) {
          return indicator[static_cast<std::uint16_t>(voxels[scene.labels->grid.offset(index)])];
        };
        return firstOutside(outside, cornersOf(piece.cell, dims, indicatorAt), piece);
      });
    });
  } else if (const auto* values = std::get_if<ValueFocus>(&scene.focus)) {
    const FocusCells cells = focusCells(*scene.volume, *values);
    const Gaps outside{{-infinity, values->values.low}, {values->values.high, infinity}};
    f([&](const Piece& piece, const Corners& corners) -> std::optional<double> {
      if (!cells.contains(piece.cell)) return {};
      return firstOutside(outside, corners, piece);
    });
  } else {
    f([](const Piece&, const Corners&) { return std::optional<double>(); });
  }
}

}  // namespace

HitPoints hitPoints(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const Grid& grid = scene.volume->grid;
  const Gaps transparent = scene.context.transparentGaps(1.0 / 255.0);
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  HitPoints result{Image(count, nothing), Image(count, nothing), Image(count, nothing)};

  withValues(*scene.volume, [&](auto valueAt) {
    withFocus(scene, [&](auto focusIn) {
      const auto cast = [&](const Ray& ray, Span span) {
        Hit hit;
        walkCells(ray, span, grid.dims, [&](const Piece& piece) {
          const Corners corners = cornersOf(piece.cell, grid.dims, valueAt);
          hit.tFocus = focusIn(piece, corners).value_or(nothing);
          if (std::isnan(hit.tContext))
            hit.tContext = std::fmin(firstOutside(transparent, corners, piece).value_or(nothing), hit.tFocus);
          return std::isnan(hit.tFocus);
        });
        return hit;
      };
      parallelFor(count, static_cast<std::size_t>(size.x), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const glm::ivec2 pixel(static_cast<int>(i % static_cast<std::size_t>(size.x)),
                                 static_cast<int>(i / static_cast<std::size_t>(size.x)));
          const Ray ray = pixelRay(camera, size, pixel);
          const std::optional<Span> span = clip(ray, grid);
          if (!span) continue;
          const Hit hit = cast(indexRay(ray, grid), *span);
          result.tContext[i] = hit.tContext;
          result.tFocus[i] = hit.tFocus;
          result.tOut[i] = span->tOut;
        }
      });
    });
  });
  return result;
}

}  // namespace fenestra::reference
