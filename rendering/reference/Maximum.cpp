#include "rendering/reference/Maximum.h"

#include "rendering/reference/ContextLabels.h"
#include "rendering/reference/Field.h"
#include "rendering/reference/FocusField.h"
#include "rendering/scene/Scene.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

struct Greatest {
  double value = -std::numeric_limits<double>::infinity();
  std::size_t label = 0;  ///< translucent, see ContextLabels
};

/// The volume, where it is context, and where each of its translucent labels does not show.
class Context {
 public:
  explicit Context(const Scene& scene) : field_(scene), focus_(scene), labels_(scene), gaps_(labels_.gaps()) {}

  /// Cuts a piece wherever the focus, a gap or the nearest voxel may begin or end and where the value turns around.
  /// Between two cuts the value rises or falls, and is context or is not: its greatest value is at a cut.
  /// Parts that end before `from` are left out.
  template <class ValueAt>
  void take(const Piece& whole, const ValueAt& valueAt, double from, Greatest& best) const {
    const auto any = [](ValueRange) { return true; };
    field_.along(whole, valueAt, any, [&](const FieldPiece& part) {
      const std::optional<Cubic> focus =
          focus_.mayHold(whole.cell) ? focus_.along(part.piece, part.value) : std::nullopt;
      const std::vector<double> cuts = cutsOf(part, focus);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        if (glm::mix(part.piece.tBegin, part.piece.tEnd, cuts[i + 1]) > from)
          takePart(part, focus, cuts[i], cuts[i + 1], best);
      return true;
    });
  }

  glm::dvec4 colour(const Greatest& best, double thickness) const {
    const auto shown = labels_.function().evaluate(belowGap(best));
    const double opacity = -labels_.opacityOf(best.label) * std::expm1(-shown.extinction * thickness);
    return {shown.colour * opacity, opacity};
  }

 private:
  /// The value, or where it is the lower end of a gap, but for rounding, the nearest one below: a function may end
  /// there in a step.
  double belowGap(const Greatest& best) const {
    for (const ValueGap& gap : gaps_[best.label]) {
      const double hair = 1e-9 * std::max(std::abs(gap.low), 1.0);
      if (gap.low - hair < best.value && best.value < gap.high)
        return std::nextafter(gap.low, -std::numeric_limits<double>::infinity());
    }
    return best.value;
  }

  std::vector<double> cutsOf(const FieldPiece& part, const std::optional<Cubic>& focus) const {
    const Stops stops = monotoneStops(part.value);
    std::vector<double> cuts(stops.s.begin(), stops.s.begin() + static_cast<std::ptrdiff_t>(stops.count));
    for (const std::vector<ValueGap>& gaps : gaps_)
      for (const ValueGap& gap : gaps)
        for (const double level : {gap.low, gap.high}) appendCrossings(part.value, stops, level, cuts);
    if (focus)
      for (const double level : {focus_.range().low, focus_.range().high})
        appendCrossings(*focus, monotoneStops(*focus), level, cuts);
    if (labels_.any()) appendMiddles(part.piece, cuts);
    std::sort(cuts.begin(), cuts.end());
    return cuts;
  }

  void takePart(const FieldPiece& part, const std::optional<Cubic>& focus, double from, double to,
                Greatest& best) const {
    if (!(from < to)) return;
    const double middle = 0.5 * (from + to), value = evaluate(part.value, middle);
    if (focus) {
      const double field = evaluate(*focus, middle);
      if (field >= focus_.range().low && field <= focus_.range().high) return;
    }
    const glm::dvec3 at = glm::mix(part.piece.begin, part.piece.end, middle) + glm::dvec3(part.piece.cell);
    const std::size_t label = labels_.numberAt(at);
    for (const ValueGap& gap : gaps_[label])
      if (gap.low < value && value < gap.high) return;
    const double greatest = std::max(evaluate(part.value, from), evaluate(part.value, to));
    if (greatest > best.value) best = {greatest, label};
  }

  Field field_;
  FocusField focus_;
  ContextLabels labels_;
  std::vector<std::vector<ValueGap>> gaps_;
};

}  // namespace

std::vector<glm::dvec4> maximumLayer(const Scene& scene, const std::vector<CutRay>& rays,
                                     const MethodStages::Maximum& maximum) {
  const Grid& grid = scene.volume->grid;
  const Context context(scene);
  std::vector<glm::dvec4> layer(rays.size(), glm::dvec4(0.0));
  const double hair = 2e-3 * std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});  // as exact as hits are
  withValues(shownVolume(scene), [&](auto valueAt) {
    parallelFor(rays.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        interruptionPoint();
        const CutRay& ray = rays[i];
        if (!(ray.span.tIn <= ray.span.tOut)) continue;
        Greatest best;
        // What rounding leaves of the context before the focus is none of it.
        const double from = ray.onFocus ? ray.span.tIn + hair : -std::numeric_limits<double>::infinity();
        for (const Span& span : {Span{ray.span.tIn, std::min(ray.hole.tIn, ray.span.tOut)},
                                 Span{std::max(ray.hole.tOut, ray.span.tIn), ray.span.tOut}}) {
          if (!(span.tIn + hair < span.tOut)) continue;
          walkCells(indexRay(ray.ray, grid), span, grid.dims, [&](const Piece& piece) {
            context.take(piece, valueAt, from, best);
            return true;
          });
        }
        if (best.value > -std::numeric_limits<double>::infinity()) layer[i] = context.colour(best, maximum.thickness);
      }
    });
  });
  return layer;
}

}  // namespace fenestra::reference
