#include "rendering/reference/Field.h"
#include "rendering/reference/FocusField.h"
#include "rendering/scene/Parallel.h"

namespace fenestra::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A closed set of values, given by the open gaps outside it. A ray inside a gap enters the set at one of that gap's
/// two ends.
using Gaps = std::vector<ValueGap>;

const ValueGap* gapAround(const Gaps& gaps, double value) {
  for (const ValueGap& gap : gaps)
    if (gap.low < value && value < gap.high) return &gap;
  return nullptr;
}

bool isInGap(const Gaps& gaps, ValueRange range) {
  return std::any_of(gaps.begin(), gaps.end(),
                     [&](const ValueGap& gap) { return gap.low < range.low && range.high < gap.high; });
}

/// First t of the piece whose value lies in none of the gaps.
std::optional<double> firstOutside(const Gaps& gaps, const Cubic& cubic, const Piece& piece) {
  const ValueGap* gap = gapAround(gaps, cubic[0]);
  if (!gap) return piece.tBegin;
  const auto left = [&](double s) {
    const double value = evaluate(cubic, s);
    return value <= gap->low || value >= gap->high;
  };
  const Stops stops = monotoneStops(cubic);
  for (std::size_t k = 0; k + 1 < stops.count; ++k) {
    if (!left(stops.s[k + 1])) continue;
    return piece.tBegin + bisect(stops.s[k], stops.s[k + 1], left) * (piece.tEnd - piece.tBegin);
  }
  return {};
}

/// First t of a ray in the context or the focus, and in the focus.
struct Hit {
  double tContext = nothing, tFocus = nothing;
};

}  // namespace

HitPoints hitPoints(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const Grid& grid = scene.volume->grid;
  const Gaps transparent = scene.look.context.shifted().transparentGaps(1.0 / 255.0);
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  HitPoints result{Image(count, nothing), Image(count, nothing), Image(count, nothing)};

  const Field field(scene);
  const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, grid);
  const FocusField focus(scene);
  const Gaps outsideFocus{{-infinity, focus.range().low}, {focus.range().high, infinity}};

  withValues(shownVolume(scene), [&](auto valueAt) {
    const auto cast = [&](const Ray& ray, Span span, bool onFace) {
      Hit hit;
      if (onFace) hit.tContext = span.tIn;
      walkCells(ray, span, grid.dims, [&](const Piece& cell) {
        const bool mayHoldFocus = focus.mayHold(cell.cell);
        const auto wants = [&](ValueRange range) {
          return mayHoldFocus || (std::isnan(hit.tContext) && !isInGap(transparent, range));
        };
        return field.along(cell, valueAt, wants, [&](const FieldPiece& part) {
          if (mayHoldFocus)
            hit.tFocus = firstOutside(outsideFocus, *focus.along(part.piece, part.value), part.piece).value_or(nothing);
          if (std::isnan(hit.tContext)) {
            const bool isClear = isInGap(transparent, part.range);
            const auto found = isClear ? std::nullopt : firstOutside(transparent, part.value, part.piece);
            hit.tContext = std::fmin(found.value_or(nothing), hit.tFocus);
          }
          return std::isnan(hit.tFocus);
        });
      });
      return hit;
    };
    parallelFor(count, static_cast<std::size_t>(size.x), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        interruptionPoint();
        const glm::ivec2 pixel(static_cast<int>(i % static_cast<std::size_t>(size.x)),
                               static_cast<int>(i / static_cast<std::size_t>(size.x)));
        const Ray ray = pixelRay(camera, size, pixel);
        const std::optional<Span> span = clip(ray, grid, kept);
        if (!span) continue;
        const bool onFace = scene.look.clipping.grey && capNormal(ray, grid, kept);
        const Hit hit = cast(indexRay(ray, grid), *span, onFace);
        result.tContext[i] = hit.tContext;
        result.tFocus[i] = hit.tFocus;
        result.tOut[i] = span->tOut;
      }
    });
  });
  return result;
}

}  // namespace fenestra::reference
