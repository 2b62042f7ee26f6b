#include "rendering/reference/ContextLabels.h"
#include "rendering/reference/Field.h"
#include "rendering/reference/FocusField.h"
#include "rendering/reference/Unknown.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

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

/// The part of a cubic between two places, from 0 to 1 over that part.
Cubic between(const Cubic& c, double from, double to) {
  const double d = to - from;
  return {evaluate(c, from), d * (c[1] + from * (2.0 * c[2] + 3.0 * from * c[3])), d * d * (c[2] + 3.0 * from * c[3]),
          d * d * d * c[3]};
}

/// The context's translucent labels, and where each of them does not show.
class ContextGaps {
 public:
  explicit ContextGaps(const Scene& scene) : labels_(scene), gaps_(labels_.gaps()) {}
  /// Whether values of that range show in no label. All else decides: labels show less.
  bool isClear(ValueRange range) const { return isInGap(gaps_.front(), range); }
  /// First t of the piece in the context.
  std::optional<double> firstHit(const FieldPiece& whole) const {
    if (!labels_.any()) return firstOutside(gaps_.front(), whole.value, whole.piece);
    const Piece& piece = whole.piece;
    std::vector<double> ends{0.0, 1.0};
    appendMiddles(piece, ends);
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const Piece part = Field::partOf(piece, ends[k], ends[k + 1]);
      const glm::dvec3 middle = glm::dvec3(piece.cell) + 0.5 * (part.begin + part.end);
      const Cubic value = between(whole.value, ends[k], ends[k + 1]);
      if (const auto found = firstOutside(gaps_[labels_.numberAt(middle)], value, part)) return found;
    }
    return {};
  }

 private:
  ContextLabels labels_;
  std::vector<Gaps> gaps_;
};

/// First t of a ray in the context or the focus, and in the focus.
struct Hit {
  double tContext = unknown, tFocus = unknown;
};

}  // namespace

HitPoints hitPoints(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  return hitPoints(scene, camera, size, centresOf(size));
}

HitPoints hitPoints(const Scene& scene, const Camera& camera, glm::ivec2 size, const std::vector<glm::dvec2>& places) {
  const Grid& grid = scene.volume->grid;
  const ContextGaps context(scene);
  const std::size_t count = places.size();
  HitPoints result{Image(count, unknown), Image(count, unknown), Image(count, unknown)};

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
          return mayHoldFocus || (std::isnan(hit.tContext) && !context.isClear(range));
        };
        return field.along(cell, valueAt, wants, [&](const FieldPiece& part) {
          if (mayHoldFocus)
            hit.tFocus = firstOutside(outsideFocus, *focus.along(part.piece, part.value), part.piece).value_or(unknown);
          if (std::isnan(hit.tContext)) {
            const bool isClear = context.isClear(part.range);
            const auto found = isClear ? std::nullopt : context.firstHit(part);
            hit.tContext = std::fmin(found.value_or(unknown), hit.tFocus);
          }
          return std::isnan(hit.tFocus);
        });
      });
      return hit;
    };
    parallelFor(count, static_cast<std::size_t>(size.x), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        interruptionPoint();
        const Ray ray = rayThrough(camera, size, places[i]);
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
