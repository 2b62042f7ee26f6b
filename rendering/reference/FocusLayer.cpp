#include "rendering/reference/FocusLayer.h"

#include <atomic>

#include "rendering/reference/FadingIntegral.h"
#include "rendering/reference/Kronrod.h"
#include "rendering/reference/Medium.h"
#include "rendering/reference/Parts.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

template <class ValueAt>
class Integrator {
 public:
  Integrator(const Medium& medium, const ValueAt& valueAt, const CutRay& ray, double tolerance)
      : medium_(medium),
        grid_(medium.scene.volume->grid),
        valueAt_(valueAt),
        ray_(ray),
        tolerance_(tolerance),
        perMillimetre_(1.0 / std::max(ray.span.tOut - ray.span.tIn, std::numeric_limits<double>::min())) {}

  void run() {
    if (ray_.grey && paintGrey()) return;
    walk();
    // An error grows where a context fades: the ray is followed again in shorter steps until it fits.
    for (int again = 0; medium_.fading && state_.error > tolerance_ && again < mostRefinements; ++again) {
      local_ /= 16.0;
      state_ = {};
      bodies_ = {};
      isBehindHole_ = false;
      walk();
    }
  }

  glm::dvec4 colour() const { return {state_.colour, -std::expm1(-state_.depth)}; }
  double error() const { return state_.error; }

 private:
  /// What a ray meets of a translucent label in one go (rendering/settings/LabelSettings.h).
  struct Body {
    int label = 0;  ///< number of the context's, or below 0, of the focus's; 0: none
    double opacity = 1.0;
    double opacitySoFar = 0.0;  ///< A: were it whole
    double end = 0.0;           ///< t of its last point so far
  };

  void walk() {
    const Span &span = ray_.span, &hole = ray_.hole;
    const double before = std::min(hole.tIn, span.tOut);
    if (ray_.ghostedTo) return walk(span);
    if (span.tIn <= before) walk({span.tIn, before});
    isBehindHole_ = true;
    bodies_ = {};
    if (hole.tOut < span.tOut) walk({std::max(hole.tOut, span.tIn), span.tOut});
  }

  /// False where the ray starts in the focus, which shows as it is.
  bool paintGrey() {
    const Ray ray = indexRay(ray_.ray, grid_);
    bool painted = false;
    const double tFace = ray_.span.tIn - ray_.beforeWall;
    walkCells(ray, {tFace, tFace}, grid_.dims, [&](const Piece& piece) {
      const double value = medium_.field.value(glm::dvec3(piece.cell) + piece.begin, valueAt_);
      if (const auto field = medium_.focus.along(piece, Cubic{value, 0.0, 0.0, 0.0}); field && ray_.grey->showsFocus) {
        const double inField = evaluate(*field, 0.0);
        if (inField >= medium_.focus.range().low && inField <= medium_.focus.range().high) return false;
      }
      const WindowLevel window = ray_.grey->window;
      const double low = window.level - 0.5 * window.width;
      const double grey = std::clamp((value - low) / window.width, 0.0, 1.0);
      state_.colour = glm::dvec3(medium_.scene.volume->lowIsWhite ? 1.0 - grey : grey);
      state_.depth = std::numeric_limits<double>::infinity();
      painted = true;
      return false;
    });
    return painted;
  }

  void walk(Span span) {
    walkCells(indexRay(ray_.ray, grid_), span, grid_.dims, [&](const Piece& piece) {
      addCell(piece);
      // The rest of the ray adds at most the transmittance times twice the colour, the most that lighting makes of it.
      if (2.0 * transmittance() > 0.1 * tolerance_) return true;
      state_.error += 2.0 * transmittance();
      return false;
    });
  }

  double transmittance() const { return state_.transmittance(); }

  void addCell(const Piece& piece) {
    const bool mayHoldFocus = medium_.focus.mayHold(piece.cell);
    const auto wants = [&](ValueRange range) {
      return mayHoldFocus || (!medium_.onlyFocus && !medium_.isClear(range));
    };
    bool hasNormals = medium_.field.spline() || !(medium_.scene.look.shading.enabled || medium_.fading);
    medium_.field.along(piece, valueAt_, wants, [&](const FieldPiece& part) {
      if (!wants(part.range)) return true;
      if (!hasNormals) findNormals(piece.cell);
      hasNormals = true;
      addPiece(part.piece, part.value, part.range, mayHoldFocus);
      return true;
    });
  }

  void addPiece(const Piece& piece, const Cubic& value, ValueRange range, bool mayHoldFocus) {
    piece_ = &piece;
    const std::optional<Cubic> field = mayHoldFocus ? medium_.focus.along(piece, value) : std::nullopt;
    const Cubic focusValue = field.value_or(Cubic{});
    const ValueRange& focusRange = medium_.focus.range();
    places_.assign({0.0, 1.0});
    const Stops stops = monotoneStops(value);
    for (const TransferFunction::Node& node : medium_.context.function().nodes)
      if (range.low <= node.value && node.value <= range.high) appendCrossings(value, stops, node.value, places_);
    if (field) {
      const Stops focusStops = monotoneStops(focusValue);
      for (const double level : {focusRange.low, focusRange.high})
        appendCrossings(focusValue, focusStops, level, places_);
      for (const double node : medium_.focusShows.nodes())
        if (range.low <= node && node <= range.high) appendCrossings(value, stops, node, places_);
    }
    if (medium_.context.any() || (field && medium_.focusShows.differ())) appendMiddles(piece, places_);
    if (medium_.scene.look.shading.enabled) appendTurns(piece);
    if (medium_.occlusion) medium_.occlusion->appendCrossings(piece, places_);
    if (medium_.region) medium_.region->appendCrossings(worldAt(piece.tBegin), worldAt(piece.tEnd), places_);
    if (ray_.ghostedTo)
      for (const double t : {*ray_.ghostedTo, ray_.hole.tIn, ray_.hole.tOut})
        if (piece.tBegin < t && t < piece.tEnd) places_.push_back((t - piece.tBegin) / (piece.tEnd - piece.tBegin));
    std::sort(places_.begin(), places_.end());

    for (std::size_t k = 0; k + 1 < places_.size(); ++k) {
      const double begin = places_[k], end = places_[k + 1], middle = 0.5 * (begin + end);
      if (!(begin < end)) continue;
      const double inField = evaluate(focusValue, middle);
      const bool held = field && inField >= focusRange.low && inField <= focusRange.high;
      if ((medium_.onlyFocus && !held) || medium_.leavesOut(held)) continue;
      inFocus_ = held && !medium_.onlyFocus;
      const glm::dvec3 at = glm::mix(piece.begin, piece.end, middle) + glm::dvec3(piece.cell);
      Part part;
      Body body;
      if (inFocus_) {
        const FocusShow& show = medium_.focusShows.at(at);
        body = {show.label > 0 ? -1 - show.label : 0, show.opacity};
        if (show.function)
          part = functionPart(*show.function, value, begin, end);
        else
          part.from = show.material;
      } else {
        const std::size_t number =
            medium_.onlyFocus ? medium_.context.numberAt(at, medium_.labelsAlone) : medium_.context.numberAt(at);
        body = {static_cast<int>(number), medium_.context.opacityOf(number)};
        part = functionPart(medium_.context.function(), value, begin, end);
      }
      part.begin = begin;
      part.end = end;
      part.length = (end - begin) * (piece.tEnd - piece.tBegin);
      if (body.label == 0)
        addWhole(part);
      else
        addOf(body, part);
    }
  }

  /// Adds a part of what is not translucent.
  void addWhole(const Part& part) {
    if (medium_.fading && !inFocus_)
      medium_.ghosting ? addGhosted(part) : medium_.region ? addAround(part) : addFading(part);
    else
      addPart(part, maxHalvings);
  }

  /// Adds a part of a body. It is found behind the transmittance that there would be, were the body whole:
  /// T0 (1 - A) in place of T0 (1 - s A). Of what that adds, s shows.
  void addOf(const Body& body, const Part& part) {
    if (!(part.depth(1.0) > 0.0)) return;
    const auto tAt = [&](double u) { return glm::mix(piece_->tBegin, piece_->tEnd, u); };
    auto at = std::find_if(bodies_.begin(), bodies_.end(), [&](const Body& met) { return met.label == body.label; });
    if (at == bodies_.end()) {
      bodies_.back() = body;  // in place of the one met longer ago
      bodies_.back().end = tAt(part.begin);
      at = std::prev(bodies_.end());
    }
    std::rotate(bodies_.begin(), at, std::next(at));
    Body& met = bodies_.front();
    met.opacitySoFar *= 1.0 - std::min((tAt(part.begin) - met.end) / medium_.bodyGap, 1.0);
    const FadingState before = state_;
    const double shown = transmittance(), whole = 1.0 - met.opacitySoFar;
    const double inFront = shown / (1.0 - body.opacity * met.opacitySoFar);  // T0
    state_ = {};
    state_.depth = -std::log(inFront * whole);
    if (whole > 0.0) addWhole(part);
    const double added = whole > 0.0 ? inFront * whole - transmittance() : 0.0;
    const FadingState found = state_;
    state_ = before;
    state_.colour += body.opacity * found.colour;
    state_.error += body.opacity * found.error;
    state_.depth = -std::log(shown - body.opacity * added);
    met.opacitySoFar = std::min(met.opacitySoFar + added / inFront, 1.0);
    met.end = tAt(part.end);
  }

  /// At the corners of a cell of trilinear values.
  void findNormals(glm::ivec3 cell) {
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 corner = cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
      const glm::dvec3 difference =
          medium_.normals.gradient(glm::clamp(corner, glm::ivec3(0), grid_.dims - 1), valueAt_);
      normals_[static_cast<std::size_t>(i)] = medium_.normals.gated(difference);
      if (medium_.fading) slopes_[static_cast<std::size_t>(i)] = difference;
    }
  }

  /// Where the normals turn from one side of the light to the other: |n·l| has a kink there.
  void appendTurns(const Piece& piece) {
    const auto towards = [&](double s) {
      return glm::dot(gatedAt(glm::mix(piece.begin, piece.end, s)), medium_.light.direction);
    };
    Cubic cubic;
    if (medium_.field.spline()) {
      cubic = through(towards(0.0), towards(1.0 / 3.0), towards(2.0 / 3.0), towards(1.0));  // near enough to halve from
    } else {
      Corners corners;
      for (std::size_t i = 0; i < 8; ++i) corners[i] = glm::dot(normals_[i], medium_.light.direction);
      cubic = alongPiece(corners, piece);
    }
    appendCrossings(cubic, monotoneStops(cubic), 0.0, places_);
  }

  /// Adds a part, halving it until the error fits.
  void addPart(const Part& part, int halvings) {
    const double thickness = part.depth(1.0), light = transmittance();
    if (!(thickness > 0.0)) return;
    glm::dvec4 fine(0.0), coarse(0.0);
    const auto add = [&](const Node& node, double u) {
      const double emission = 0.5 * part.length * part.extinction(u) * light * std::exp(-part.depth(u));
      const glm::dvec4 sample = emission * glm::dvec4(shade(part, u), 1.0);
      fine += node.kronrod * sample;
      coarse += node.gauss * sample;
    };
    for (const Node& node : rule) {
      add(node, 0.5 - 0.5 * node.offset);
      if (node.offset > 0.0) add(node, 0.5 + 0.5 * node.offset);
    }
    // Opacity is known exactly, so comparing with it exposes samples that miss the place where light is absorbed.
    const double opacity = -light * std::expm1(-thickness);
    const glm::dvec4 difference = glm::abs(fine - coarse);
    const double error = std::max({difference.r, difference.g, difference.b, std::abs(fine.a - opacity)});
    const double allowed = tolerance_ * (0.5 * opacity + 0.4 * part.length * perMillimetre_);
    if (error > std::max(allowed, rounding) && halvings > 0) {
      addPart(part.half(false), halvings - 1);
      addPart(part.half(true), halvings - 1);
      return;
    }
    state_.colour += glm::dvec3(fine);
    state_.depth += thickness;
    state_.error += error + opacity * state_.drift;
  }

  /// Adds a part of a context that fades.
  void addFading(const Part& part) {
    if (!(part.depth(1.0) > 0.0)) return;
    const double sharpness = medium_.fading->sharpness;
    const FadingTolerance tolerance{0.5 * local_, 0.4 * local_ * perMillimetre_, 0.05 * tolerance_};
    integrateFading(state_, sharpness, part.length, tolerance, [&](double u) {
      const double s = glm::mix(part.begin, part.end, u);
      const glm::dvec3 at = glm::mix(piece_->begin, piece_->end, s);
      const double t = glm::mix(piece_->tBegin, piece_->tEnd, s), near = 1.0 - medium_.eyeRange.distance(t);
      const double intensity =
          medium_.scene.look.shading.enabled ? medium_.light.intensity(gatedAt(at), ray_.ray.direction) : 1.0;
      return FadingPoint{part.extinction(u), slopeAt(at), std::pow(medium_.fading->reach * intensity * near, sharpness),
                         shade(part, u)};
    });
  }

  /// Adds a part of the context, which lies inside or outside of a focal region.
  void addAround(const Part& part) {
    if (!(part.depth(1.0) > 0.0)) return;
    const auto distanceAt = [&](double u) {
      return medium_.region->distance(
          worldAt(glm::mix(piece_->tBegin, piece_->tEnd, glm::mix(part.begin, part.end, u))));
    };
    const bool inside = !(distanceAt(0.5) > 0.0);
    if (inside) return addPart(part, maxHalvings);
    const FadingTolerance tolerance{0.5 * local_, 0.4 * local_ * perMillimetre_, 0.05 * tolerance_};
    integrateFading(state_, 0.0, part.length, tolerance, [&](double u) {
      const glm::dvec3 at = glm::mix(piece_->begin, piece_->end, glm::mix(part.begin, part.end, u));
      return FadingPoint{part.extinction(u) * medium_.region->shareAt(distanceAt(u)), slopeAt(at), 1.0, shade(part, u)};
    });
  }

  /// Adds a part of the context that is a ghost, or is not.
  void addGhosted(const Part& part) {
    if (!(part.depth(1.0) > 0.0)) return;
    const double middle = glm::mix(piece_->tBegin, piece_->tEnd, 0.5 * (part.begin + part.end));
    const bool isGhost =
        middle < ray_.ghostedTo.value_or(middle) || (ray_.hole.tIn < middle && middle < ray_.hole.tOut);
    if (!isGhost) return addPart(part, maxHalvings);
    const FadingTolerance tolerance{0.5 * local_, 0.4 * local_ * perMillimetre_, 0.05 * tolerance_};
    integrateFading(state_, 0.0, part.length, tolerance, [&](double u) {
      const glm::dvec3 at = glm::mix(piece_->begin, piece_->end, glm::mix(part.begin, part.end, u));
      const double factor = medium_.ghosting->factor(gradientAt(at), ray_.ray.direction);
      return FadingPoint{part.extinction(u) * factor, 1.0, 1.0, shade(part, u)};
    });
  }

  glm::dvec3 worldAt(double t) const { return ray_.ray.origin + t * ray_.ray.direction; }

  /// World gradient at a place in the cell, of length 1 for the steepest.
  glm::dvec3 gradientAt(glm::dvec3 at) const {
    if (!(medium_.steepest > 0.0)) return glm::dvec3(0.0);
    const SplineVolume* spline = medium_.field.spline();
    const glm::dvec3 slope = spline ? spline->gradient(at + glm::dvec3(piece_->cell)) : interpolate(slopes_, at);
    return medium_.normals.world(slope) / medium_.steepest;
  }
  double slopeAt(glm::dvec3 at) const { return std::min(glm::length(gradientAt(at)), 1.0); }

  glm::dvec3 shade(const Part& part, double u) {
    const glm::dvec3 colour = part.colour(u);
    if (!medium_.scene.look.shading.enabled) return colour;
    const double s = glm::mix(part.begin, part.end, u);
    const glm::dvec3 at = glm::mix(piece_->begin, piece_->end, s), world = ray_.ray.direction;
    const glm::dvec2 open = medium_.occlusion ? medium_.occlusion->at(at + glm::dvec3(piece_->cell)) : glm::dvec2(1.0);
    glm::dvec3 shaded = medium_.light.shade(colour, normalAt(at), world, open);
    if (ray_.wall != glm::dvec3(0.0) && !isBehindHole_) {
      const double behind = piece_->tBegin + s * (piece_->tEnd - piece_->tBegin) - ray_.span.tIn + ray_.beforeWall;
      const double share = lighting::wallShare * std::exp(-behind / medium_.wallDepth);
      shaded = glm::mix(shaded, medium_.light.lit(colour, ray_.wall, world, open), share);
    }
    return shaded;
  }

  glm::dvec3 normalAt(glm::dvec3 at) {
    if (inFocus_ && medium_.focusNormals) {
      const glm::dvec3 normal = medium_.focusNormals->at(at + glm::dvec3(piece_->cell));
      const double length = glm::length(normal);
      if (length > flatFocus) return normal / length;
    }
    return gatedAt(at);
  }

  /// The context's gated normal at a place in the cell.
  glm::dvec3 gatedAt(glm::dvec3 at) const {
    return medium_.splineNormals ? medium_.splineNormals->at(at + glm::dvec3(piece_->cell)) : interpolate(normals_, at);
  }

  /// 2^-52 of a part is below the resolution of its ends. An error below one rounding of 1 cannot be reached.
  static constexpr int maxHalvings = 52;
  static constexpr int mostRefinements = 6;
  static constexpr double rounding = std::numeric_limits<double>::epsilon();
  /// Gradient of the smoothed indicator (1/mm) below which a point lies too deep in the focus to have a normal.
  static constexpr double flatFocus = 1e-3;

  const Medium& medium_;
  const Grid& grid_;
  const ValueAt& valueAt_;
  const CutRay& ray_;
  const double tolerance_, perMillimetre_;

  std::array<Body, 2> bodies_{};  ///< the last ones, the last one first

  // The current cell and the part of it.
  const Piece* piece_ = nullptr;
  std::vector<double> places_;
  std::array<glm::dvec3, 8> normals_{}, slopes_{};
  bool inFocus_ = false;
  bool isBehindHole_ = false;

  FadingState state_;  ///< without a context that fades, too
  double local_ = 0.25 * tolerance_;
};

FocusLayer integrated(const Medium& medium, const std::vector<CutRay>& rays, double tolerance) {
  const Scene& scene = medium.scene;
  FocusLayer layer{std::vector<glm::dvec4>(rays.size(), glm::dvec4(0.0)), Image(rays.size(), 0.0)};
  withValues(shownVolume(scene), [&](auto valueAt) {
    // Rays differ widely in cost: threads take blocks of them as they get free.
    constexpr std::size_t block = 64;
    std::atomic<std::size_t> next = 0;
    const std::size_t blocks = (rays.size() + block - 1) / block;
    parallelFor(blocks, 1, [&](std::size_t, std::size_t) {
      for (std::size_t at = next++; at < blocks; at = next++)
        for (std::size_t i = at * block; i < std::min((at + 1) * block, rays.size()); ++i) {
          interruptionPoint();
          if (!(rays[i].span.tIn <= rays[i].span.tOut)) continue;
          Integrator integrator(medium, valueAt, rays[i], tolerance);
          integrator.run();
          layer.colour[i] = integrator.colour();
          layer.error[i] = integrator.error();
        }
    });
  });
  return layer;
}

/// The parts of rays between the context's first hit and where they start to see.
std::vector<CutRay> removedOf(std::vector<CutRay> rays, const Image& tContext) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double start = rays[i].ghostedTo.value_or(rays[i].span.tIn);
    rays[i].span = std::isnan(tContext[i]) ? Span{1.0, 0.0} : Span{tContext[i], start};
    rays[i].ghostedTo.reset();
    rays[i].wall = glm::dvec3(0.0);
    rays[i].grey.reset();
  }
  return rays;
}

}  // namespace

FocusLayer focusLayer(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays, double tolerance,
                      const Occlusion* occlusion) {
  return integrated(Medium(scene, camera, occlusion), rays, tolerance);
}

FocusLayer layerOf(Alone shown, const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays,
                   double tolerance) {
  Medium medium(scene, camera, nullptr);
  medium.alone = shown;
  return integrated(medium, rays, tolerance);
}

FocusLayer protectedLayer(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays,
                          const Image& tContext, double tolerance, const Occlusion* occlusion) {
  return integrated(Medium::ofLabels(scene, camera, labelsWith(LabelRole::Protected, scene), occlusion),
                    removedOf(rays, tContext), tolerance);
}

FocusLayer removedLayer(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays,
                        const Image& tContext, double tolerance, const Occlusion* occlusion) {
  // With several levels of importance it removes those parts of the focus that hide more important labels.
  if (!importanceLevels(scene).empty())
    return integrated(Medium(scene, camera, occlusion), removedOf(rays, tContext), tolerance);
  // Else the opening never removes any of the focus.
  Scene unfocused = scene;
  unfocused.look.focus = {};
  const Medium medium(scene, camera, FocusField(unfocused), occlusion);
  return integrated(medium, removedOf(rays, tContext), tolerance);
}

ExemptLayers exemptLayers(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays, double tolerance,
                          const Occlusion* occlusion) {
  const Grid& grid = scene.volume->grid;
  const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, grid);
  std::vector<CutRay> before, behind;
  for (const CutRay& each : rays) {
    CutRay ray{.ray = each.ray, .span = {1.0, 0.0}};
    CutRay &first = before.emplace_back(ray), &last = behind.emplace_back(ray);
    const std::optional<Span> whole = clip(each.ray, grid), inside = clip(each.ray, grid, kept);
    if (!whole) continue;
    first.span = {whole->tIn, inside ? inside->tIn : whole->tOut};
    if (inside) last.span = {inside->tOut, whole->tOut};
  }
  const Medium medium = Medium::ofLabels(scene, camera, scene.look.clipping.exempt, occlusion);
  return {integrated(medium, before, tolerance), integrated(medium, behind, tolerance)};
}

}  // namespace fenestra::reference
