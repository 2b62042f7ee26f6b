#include "rendering/viewpoints/Placement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace fenestra::placement {
namespace {

bool sees(const std::vector<std::uint64_t>& bits, std::size_t point) { return bits[point / 64] >> (point % 64) & 1u; }

/// Jensen–Shannon divergence in bits of two uniform distributions over the points they see; in [0, 1].
double divergence(const Candidate& a, const Candidate& b) {
  double onlyA = 0.0, onlyB = 0.0, both = 0.0;
  for (std::size_t word = 0; word < a.seen.size(); ++word) {
    onlyA += std::popcount(a.seen[word] & ~b.seen[word]);
    onlyB += std::popcount(b.seen[word] & ~a.seen[word]);
    both += std::popcount(a.seen[word] & b.seen[word]);
  }
  const double pa = onlyA + both, pb = onlyB + both;
  if (pa == 0.0 || pb == 0.0) return pa == pb ? 0.0 : 1.0;
  const auto half = [&](double only, double p) {
    const double shared = 1.0 / p, mixed = 0.5 * (1.0 / pa + 1.0 / pb);
    return (only * shared + both * shared * std::log2(shared / mixed));  // log2(shared / (shared / 2)) = 1 for `only`
  };
  return std::clamp(0.5 * (half(onlyA, pa) + half(onlyB, pb)), 0.0, 1.0);
}

/// Nearest candidates that stability compares with: a HEALPix pixel has at most eight neighbours.
constexpr std::size_t neighbourCount = 8;

/// What all of the surface is worth in terms of quality, to compare costs with it: between the best views of a
/// structure and the middling ones lie some 0.1 of its surface and, of a small structure, some 0.2 of the
/// quality.
constexpr double qualityOfSurface = 2.0;

}  // namespace

double seenPoints(const Candidate& candidate) {
  double count = 0.0;
  for (const std::uint64_t word : candidate.seen) count += std::popcount(word);
  return count;
}

Descriptors describe(const ImageSums& sums, int side, glm::dvec3 direction) {
  Descriptors d;
  const glm::dvec3 size = glm::abs(direction);
  d.orientation = std::max({size.x, size.y, size.z});
  if (sums.count <= 0.0) return d;
  d.visibility = sums.depth / sums.count;
  d.coverage = sums.count / (static_cast<double>(side) * side);
  d.location = 1.0 - std::min(1.0, glm::length(sums.position / sums.count) / std::numbers::sqrt2);
  d.endFace = sums.ends / sums.count;
  return d;
}

void describeTogether(std::vector<Candidate>& candidates, std::size_t points) {
  if (points < 2) return;
  // p(o), averaged over the candidates that see anything.
  std::vector<double> mean(points, 0.0);
  double seeing = 0.0;
  for (const Candidate& candidate : candidates) {
    const double count = seenPoints(candidate);  // they stand for equal areas, so p(o|v) is 1 / count for each
    if (count == 0.0) continue;
    ++seeing;
    for (std::size_t o = 0; o < points; ++o)
      if (sees(candidate.seen, o)) mean[o] += 1.0 / count;
  }
  if (seeing == 0.0) return;
  double greatest = 0.0;
  std::vector<double> information(candidates.size(), 0.0);
  for (std::size_t v = 0; v < candidates.size(); ++v) {
    Candidate& candidate = candidates[v];
    const double count = seenPoints(candidate);
    if (count == 0.0) continue;
    candidate.descriptors.entropy = std::log(count) / std::log(static_cast<double>(points));
    for (std::size_t o = 0; o < points; ++o)
      if (sees(candidate.seen, o)) information[v] += std::log(seeing / (count * mean[o])) / count;
    greatest = std::max(greatest, information[v]);
  }
  for (std::size_t v = 0; v < candidates.size(); ++v)
    if (seenPoints(candidates[v]) > 0.0)
      candidates[v].descriptors.mutualInformation = greatest > 0.0 ? 1.0 - information[v] / greatest : 1.0;

  std::vector<std::size_t> order(candidates.size());
  for (std::size_t v = 0; v < candidates.size(); ++v) {
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const std::size_t near = std::min(neighbourCount + 1, order.size());
    const auto nearer = [&](std::size_t a, std::size_t b) {
      const double da = glm::dot(candidates[a].direction, candidates[v].direction);
      const double db = glm::dot(candidates[b].direction, candidates[v].direction);
      return da != db ? da > db : a < b;
    };
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(near), order.end(), nearer);
    double sum = 0.0;
    for (std::size_t i = 1; i < near; ++i) sum += divergence(candidates[v], candidates[order[i]]);
    candidates[v].descriptors.stability = near > 1 ? 1.0 - sum / static_cast<double>(near - 1) : 1.0;
  }
}

double quality(const Descriptors& d, const Weights& w) {
  return w.visibility * d.visibility + w.coverage * d.coverage + w.location * d.location + w.entropy * d.entropy +
         w.mutualInformation * d.mutualInformation + w.stability * d.stability + w.orientation * d.orientation +
         w.endFace * d.endFace;
}

double worth(const Descriptors& descriptors, const Options& options) {
  return quality(descriptors, options.weights) - qualityOfSurface * costOf(descriptors.awkwardness, options.habits);
}

Camera::Axes axesAt(glm::dvec3 direction) {
  Camera camera;
  camera.target = glm::dvec3(0.0);
  camera.eye = direction;
  camera.up = uprightFrom(direction);
  return camera.axes();
}

bool inRegion(glm::dvec3 c1, glm::dvec3 c2, const Options& options) {
  // Directions on the very rim belong to the region: rounding must not drop a standard view.
  constexpr double rim = 1e-9;
  constexpr double mostAlong = 0.5;  // cos 60°
  const double along = std::abs(glm::dot(c1, c2));
  if (along > mostAlong + rim) return false;
  if (options.region == Region::Stream) return along <= std::sin(glm::radians(options.streamHalfWidth)) + rim;
  return glm::dot(c2, axesAt(c1).right) >= -rim;
}

namespace {

/// The candidates that see the focus, that `may` take and that are admitted among those.
template <class May>
std::vector<bool> admittedAmong(const std::vector<Candidate>& candidates, const Options& options, const May& may) {
  CutEndRule rule(options.habits);
  std::vector<bool> admitted;
  for (const Candidate& candidate : candidates) {
    admitted.push_back(candidate.sums.count > 0.0 && may(candidate));
    if (admitted.back()) rule.add(candidate.descriptors.awkwardness, seenPoints(candidate));
  }
  for (std::size_t i = 0; i < candidates.size(); ++i)
    admitted[i] = admitted[i] && rule.admits(candidates[i].descriptors.awkwardness, seenPoints(candidates[i]));
  return admitted;
}

template <class May>
std::optional<std::size_t> bestAmong(const std::vector<Candidate>& candidates, const Options& options, const May& may) {
  const std::vector<bool> admitted = admittedAmong(candidates, options, may);
  std::optional<std::size_t> best;
  double greatest = 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!admitted[i]) continue;
    const double w = worth(candidates[i].descriptors, options);
    if (best && w <= greatest) continue;
    best = i;
    greatest = w;
  }
  return best;
}

bool any(const Candidate&) { return true; }

}  // namespace

std::vector<bool> admitted(const std::vector<Candidate>& candidates, const Options& options) {
  return admittedAmong(candidates, options, any);
}

std::optional<std::size_t> bestView(const std::vector<Candidate>& candidates, const Options& options) {
  return bestAmong(candidates, options, any);
}

std::optional<std::size_t> dualView(const std::vector<Candidate>& candidates, glm::dvec3 c1, const Options& options) {
  return bestAmong(candidates, options,
                   [&](const Candidate& candidate) { return inRegion(c1, candidate.direction, options); });
}

double seenShare(const Candidate& a, const Candidate& b, std::size_t points) {
  if (points == 0) return 0.0;
  std::size_t count = 0;
  for (std::size_t word = 0; word < a.seen.size(); ++word)
    count += static_cast<std::size_t>(std::popcount(a.seen[word] | b.seen[word]));
  return static_cast<double>(count) / static_cast<double>(points);
}

namespace {

/// Pairs whose values differ by less are equally good: a share of the surface is known to about a hundredth.
constexpr double sameValue = 0.01;
/// C1 is the view that people look at first.
constexpr double sharesOfC1 = 0.8;

/// How much lies between a camera and the focus: its depth, less a little for views near a standard one, and more for
/// views that habits avoid.
double farness(const Descriptors& d, double cost) {
  constexpr double perOrientation = 0.1;
  return d.visibility - perOrientation * d.orientation + qualityOfSurface * cost;
}

/// A candidate of the joint search, with the most that it can add to a pair's value.
struct View {
  std::size_t index;
  double quality, cost, bound, farness;
};

/// Calls `visit(a, b)` for each two views that may stand together and whose bounds add up to at least `least()`.
/// `views` are sorted by bound, the greatest first.
template <class Least, class Visit>
void forEachPair(const std::vector<View>& views, const std::vector<Candidate>& candidates, const Options& options,
                 Least&& least, Visit&& visit) {
  for (std::size_t a = 0; a < views.size(); ++a)
    for (std::size_t b = a + 1; b < views.size() && views[a].bound + views[b].bound >= least(); ++b) {
      const glm::dvec3 first = candidates[views[a].index].direction, second = candidates[views[b].index].direction;
      if (inRegion(first, second, options) || inRegion(second, first, options)) visit(views[a], views[b]);
    }
}

/// The views that `may` be taken, by what they can add.
std::vector<View> viewsOf(const std::vector<Candidate>& candidates, const std::vector<bool>& may, std::size_t points,
                          const Options& options) {
  std::vector<View> views;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!may[i]) continue;
    const Descriptors& d = candidates[i].descriptors;
    const double q = quality(d, options.weights), cost = costOf(d.awkwardness, options.habits);
    const double share = seenShare(candidates[i], candidates[i], points);
    // Whatever the other view costs, this one adds at least so much to the pair's cost.
    const double most = options.shareWeight * share + (1.0 - options.shareWeight) * 0.5 * q - costOfPair(0.0, cost);
    views.push_back({i, q, cost, most, farness(d, cost)});
  }
  std::stable_sort(views.begin(), views.end(), [](const View& a, const View& b) { return a.bound > b.bound; });
  return views;
}

std::optional<Pair> bestPair(const std::vector<View>& views, const std::vector<Candidate>& candidates,
                             std::size_t points, const Options& options) {
  const double shareWeight = options.shareWeight;
  const auto valueOf = [&](const View& a, const View& b) {
    const double share = seenShare(candidates[a.index], candidates[b.index], points);
    return shareWeight * share + (1.0 - shareWeight) * 0.5 * (a.quality + b.quality) - costOfPair(a.cost, b.cost);
  };

  double greatest = -std::numeric_limits<double>::infinity();
  forEachPair(
      views, candidates, options, [&] { return greatest; },
      [&](const View& a, const View& b) { greatest = std::max(greatest, valueOf(a, b)); });

  /// In the order in which equally good pairs are preferred.
  struct Found {
    double farness, value;
    std::size_t c1, c2;
    auto order() const { return std::tuple(farness, -value, c1, c2); }
  };
  std::optional<Found> best;
  forEachPair(
      views, candidates, options, [&] { return greatest - sameValue; },
      [&](const View& a, const View& b) {
        const double value = valueOf(a, b);
        if (value < greatest - sameValue) return;
        // Where both are equally far, the better one is C1, then the one with the lower index.
        const auto role = [](const View& view) { return std::tuple(view.farness, -view.quality, view.index); };
        const View &c1 = role(a) < role(b) ? a : b, &c2 = &c1 == &a ? b : a;
        const Found found{sharesOfC1 * c1.farness + (1.0 - sharesOfC1) * c2.farness, value, c1.index, c2.index};
        if (!best || found.order() < best->order()) best = found;
      });
  if (!best) return std::nullopt;
  return Pair{best->c1, best->c2, seenShare(candidates[best->c1], candidates[best->c2], points)};
}

}  // namespace

std::optional<Pair> jointSearch(const std::vector<Candidate>& candidates, std::size_t points, const Options& options) {
  const auto search = [&](const Options& by) {
    return bestPair(viewsOf(candidates, admitted(candidates, by), points, by), candidates, points, by);
  };
  if (const std::optional<Pair> pair = search(options)) return pair;
  Options lenient = options;
  lenient.habits.avoidCutEnds = false;
  return search(lenient);
}

std::optional<Pair> bestStandardPair(const std::vector<Candidate>& candidates, std::size_t points) {
  std::optional<Pair> best;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    for (std::size_t j = i + 1; j < candidates.size(); ++j) {
      if (candidates[i].descriptors.orientation != 1.0 || candidates[j].descriptors.orientation != 1.0) continue;
      if (glm::dot(candidates[i].direction, candidates[j].direction) != 0.0) continue;
      const double share = seenShare(candidates[i], candidates[j], points);
      if (!best || share > best->share) best = Pair{i, j, share};
    }
  return best;
}

}  // namespace fenestra::placement
