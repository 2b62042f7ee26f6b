#include "tests/bench/ContextMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "rendering/reference/FadingIntegral.h"
#include "rendering/reference/FocalRegion.h"
#include "rendering/reference/Ghosting.h"
#include "rendering/volume/Threads.h"

namespace fenestra::bench {
namespace {

std::size_t offset(glm::ivec2 size, glm::ivec2 pixel) {
  return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(pixel.x);
}

bool isInside(glm::ivec2 size, glm::ivec2 pixel) {
  return glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, size));
}

/// A method's effect on one stretch.
struct Treated {
  double removed = 0.0;  ///< share of its length before the ray's start
  double share = 0.0;    ///< w, of that
  double factor = 1.0;   ///< m, of the rest
  double weight = 0.0;   ///< what it adds to the pixel's opacity
  double kept() const { return removed * share + (1.0 - removed) * factor; }
};

/// The structure of the focus, or of the context, that adds most.
std::uint16_t mainLabel(const std::vector<Stretch>& stretches, const std::vector<Treated>& treated, bool ofFocus) {
  std::map<std::uint16_t, double> sums;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (stretches[i].isFocus == ofFocus) sums[stretches[i].label] += treated[i].weight;
  const auto most =
      std::max_element(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == sums.end() ? std::uint16_t{0} : most->first;
}

double contextBefore(const std::vector<Stretch>& stretches, const std::vector<Treated>& treated, double limit) {
  double sum = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (!stretches[i].isFocus && stretches[i].middle() < limit) sum += treated[i].weight;
  return sum;
}

double ofFocus(const std::vector<Stretch>& stretches, const std::vector<Treated>& treated) {
  double sum = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (stretches[i].isFocus) sum += treated[i].weight;
  return sum;
}

}  // namespace

std::vector<float> lensShares(const MethodStages::Lens& lens, double radius, glm::ivec2 size,
                              const std::vector<float>& tContext, const std::vector<float>& tFocus,
                              const std::vector<glm::vec4>& surfaces) {
  const auto keptBesideBends = [&](double place, std::size_t at) {
    if (place >= 1.0) return 1.0;
    if (lens.fade == LensFade::Distance) return place;
    if (lens.fade == LensFade::Curvature || std::isnan(tFocus[at])) return lens.fade == LensFade::Depth ? 1.0 : 0.0;
    return std::clamp((tFocus[at] - tContext[at]) / radius, 0.0, 1.0);
  };
  std::vector<float> shares;
  shares.reserve(surfaces.size());
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const glm::ivec2 pixel(i, j);
      const std::size_t at = offset(size, pixel);
      if (std::isnan(surfaces[at].w)) {
        shares.push_back(1.0f);
        continue;
      }
      glm::dvec3 bend(0.0);
      for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
        if (isInside(size, pixel + step))
          bend += glm::abs(glm::dvec3(surfaces[offset(size, pixel + step)]) - glm::dvec3(surfaces[at]));
      const double kept = std::max(glm::length(bend) * lens.bends, keptBesideBends(surfaces[at].w / radius, at));
      shares.push_back(static_cast<float>(std::clamp(kept, 0.0, 1.0)));
    }
  return shares;
}

/// A method along the rays of a view.
class ViewSamples::Along {
 public:
  Along(const ViewSamples& view, const MethodRays& method) : view_(view), method_(method) {
    if (method.fading && method.fading->region) {
      const MethodStages::Fading::Region& region = *method.fading->region;
      if (region.shape == FocalShape::Distance)
        region_.emplace(region, view.sampler_.scene());
      else
        region_.emplace(region, view.sampler_.focusCentre());
    }
    if (method.fading && method.fading->ghost) ghost_.emplace(*method.fading->ghost);
  }

  std::vector<Treated> operator()(const SampledRay& sampled, std::size_t pixel) const {
    std::vector<Treated> all(sampled.stretches.size());
    double removedDepth = 0.0;
    if (!method_.starts.empty() && !ghost_) removedDepth = addRemoved(sampled, pixel, all);
    const double share = shareAt(pixel);
    // The part that stays faint lies over the rest as a layer of its own: w E + (1 - w a) F.
    const double through = 1.0 + share * std::expm1(-removedDepth);
    double depth = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Stretch& stretch = sampled.stretches[i];
      if (method_.fading && !stretch.isFocus) all[i].factor = factorOf(sampled.ray, pixel, stretch, depth);
      const double own = stretch.depth() * (1.0 - all[i].removed) * all[i].factor;
      all[i].weight -= through * std::exp(-depth) * std::expm1(-own);
      depth += own;
    }
    return all;
  }

 private:
  double shareAt(std::size_t pixel) const { return method_.shares.empty() ? 0.0 : double{method_.shares[pixel]}; }

  /// Share of a stretch that lies before the ray's start.
  double shareBeforeStart(const Stretch& stretch, std::size_t pixel) const {
    return std::clamp((double{method_.starts[pixel]} - stretch.begin) / stretch.length(), 0.0, 1.0);
  }

  /// Returns the optical depth of what is removed.
  double addRemoved(const SampledRay& sampled, std::size_t pixel, std::vector<Treated>& all) const {
    const double share = shareAt(pixel);
    double depth = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Stretch& stretch = sampled.stretches[i];
      if (stretch.isFocus) continue;  // an opening removes none of it
      all[i].removed = shareBeforeStart(stretch, pixel);
      all[i].share = share;
      const double own = stretch.depth() * all[i].removed;
      all[i].weight = -share * std::exp(-depth) * std::expm1(-own);
      depth += own;
    }
    return depth;
  }

  /// m at the middle of a stretch, `depth` being what lies before the stretch.
  double factorOf(const reference::Ray& ray, std::size_t pixel, const Stretch& stretch, double depth) const {
    const double t = stretch.middle();
    if (ghost_) {
      const double ghost = ghost_->factor(stretch.gradient, ray.direction);
      return glm::mix(1.0, ghost, shareBeforeStart(stretch, pixel));
    }
    if (region_) {
      const double away = region_->distance(ray.origin + t * ray.direction);
      return away > 0.0 ? stretch.slope * region_->shareAt(away) : 1.0;
    }
    const double sharpness = method_.fading->sharpness, near = 1.0 - view_.eyeRange_.distance(t);
    const reference::FadingPoint point{
        stretch.extinction, stretch.slope, std::pow(method_.fading->reach * stretch.light * near, sharpness), {}};
    const double before = reference::fadeOf(point, depth, sharpness);
    return reference::fadeOf(point, depth + 0.5 * stretch.depth() * before, sharpness);
  }

  const ViewSamples& view_;
  const MethodRays& method_;
  std::optional<reference::FocalRegion> region_;
  std::optional<reference::Ghosting> ghost_;
};

ViewSamples::ViewSamples(const RaySampler& sampler, const Camera& camera, glm::ivec2 size,
                         const std::vector<float>& tContext, const std::vector<float>& tFocus, Sampling sampling)
    : sampler_(sampler),
      camera_(camera),
      eyeRange_(eyeRangeOf(camera, sampler.scene().volume->grid)),
      tContext_(tContext),
      tFocus_(tFocus) {
  addGrid(size, sampling.step, tContext, tFocus);
  addOutlines(size, sampling.outlines, tContext, tFocus);
}

void ViewSamples::addGrid(glm::ivec2 size, int step, const std::vector<float>& tContext,
                          const std::vector<float>& tFocus) {
  std::vector<glm::ivec2> pixels;
  for (int j = step / 2; j < size.y; j += step)
    for (int i = step / 2; i < size.x; i += step)
      if (!std::isnan(tContext[offset(size, {i, j})])) pixels.emplace_back(i, j);
  const reference::Light light(camera_, sampler_.scene().look.shading);
  const glm::dvec3 forward = camera_.axes().forward;
  grid_.resize(pixels.size());
  parallelFor(pixels.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t at = offset(size, pixels[i]);
      const reference::Ray ray = reference::pixelRay(camera_, size, pixels[i]);
      const double cosine = glm::dot(ray.direction, forward);
      grid_[i] = {at, cosine * cosine * cosine, !(tFocus[at] <= tContext[at]),
                  sampler_.along(ray, double{tContext[at]}, light)};
    }
  });
}

void ViewSamples::addOutlines(glm::ivec2 size, int most, const std::vector<float>& tContext,
                              const std::vector<float>& tFocus) {
  std::vector<std::pair<glm::ivec2, glm::ivec2>> all;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i)
      for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const glm::ivec2 p(i, j), q = p + step;
        if (!isInside(size, q) || std::isnan(tFocus[offset(size, p)])) continue;
        if (std::isnan(tFocus[offset(size, q)]) && !std::isnan(tContext[offset(size, q)])) all.emplace_back(p, q);
      }
  const std::size_t every = std::max<std::size_t>(all.size() / static_cast<std::size_t>(std::max(most, 1)), 1);
  const reference::Light light(camera_, sampler_.scene().look.shading);
  outlines_.resize((all.size() + every - 1) / every);
  parallelFor(outlines_.size(), 16, [&](std::size_t begin, std::size_t end) {
    const auto sampled = [&](glm::ivec2 pixel) {
      return sampler_.along(reference::pixelRay(camera_, size, pixel), double{tContext[offset(size, pixel)]}, light);
    };
    for (std::size_t i = begin; i < end; ++i) {
      const auto [p, q] = all[i * every];
      outlines_[i] = {offset(size, p), offset(size, q), sampled(p), sampled(q)};
    }
  });
}

double ViewSamples::areaAt(const GridRay& ray, double t) const {
  return camera_.projection == Projection::Perspective ? ray.area * t * t : 1.0;
}

ContextKept ViewSamples::kept(const MethodRays& method) const {
  const Along along(*this, method);
  double volume = 0.0, keptVolume = 0.0, surface = 0.0, keptSurface = 0.0;
  for (const GridRay& ray : grid_) {
    const std::vector<Treated> treated = along(ray.sampled, ray.pixel);
    const double skinEnd = double{tContext_[ray.pixel]} + sampler_.finestSpacing();
    double skin = 0.0, keptSkin = 0.0;
    for (std::size_t i = 0; i < treated.size(); ++i) {
      const Stretch& stretch = ray.sampled.stretches[i];
      if (stretch.isFocus) continue;
      const double mass = areaAt(ray, stretch.middle()) * stretch.depth();
      volume += mass;
      keptVolume += mass * treated[i].kept();
      if (stretch.middle() > skinEnd) continue;
      skin += stretch.depth();
      keptSkin += stretch.depth() * treated[i].kept();
    }
    if (!ray.meetsContextFirst || !(skin > 0.0)) continue;
    const double area = areaAt(ray, double{tContext_[ray.pixel]});
    surface += area;
    keptSurface += area * keptSkin / skin;
  }
  return {volume > 0.0 ? keptVolume / volume : 1.0, surface > 0.0 ? keptSurface / surface : 1.0};
}

DepthOrder ViewSamples::order(const MethodRays& method) const {
  struct Seen {
    double all = 0.0, wrong = 0.0;
    void add(double seen, double error) {
      all += seen;
      wrong += seen * error;
    }
  };
  const Along along(*this, method);
  Seen outlines;
  std::map<std::pair<std::uint16_t, std::uint16_t>, Seen> pairs;
  for (const Outline& outline : outlines_) {
    const std::vector<Treated> p = along(outline.p, outline.inside), q = along(outline.q, outline.outside);
    const double nearest = double{tContext_[outline.outside]}, focus = double{tFocus_[outline.inside]};
    double error = 0.0;
    if (nearest < focus - sampler_.finestSpacing()) {
      const double half = 0.5 * (nearest + focus);
      error = std::max(contextBefore(outline.q.stretches, q, half) - contextBefore(outline.p.stretches, p, half), 0.0);
    }
    const double seen = ofFocus(outline.p.stretches, p);
    outlines.add(seen, error);
    pairs[{mainLabel(outline.p.stretches, p, true), mainLabel(outline.q.stretches, q, false)}].add(seen, error);
  }
  DepthOrder order;
  if (outlines.all > 0.0) order.wrong = outlines.wrong / outlines.all;
  for (const auto& [labels, seen] : pairs) {
    if (seen.all < 0.5) continue;
    ++order.pairs;
    order.wrongPairs += seen.wrong > 0.5 * seen.all;
  }
  return order;
}

std::vector<double> ViewSamples::opacities(const MethodRays& method) const {
  const Along along(*this, method);
  std::vector<double> result;
  for (const GridRay& ray : grid_) {
    double sum = 0.0;
    for (const Treated& each : along(ray.sampled, ray.pixel)) sum += each.weight;
    result.push_back(sum);
  }
  return result;
}

}  // namespace fenestra::bench
