#include "rendering/placement/Placement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "rendering/placement/Sphere.h"

namespace fenestra::placement {
namespace {

bool sees(const std::vector<std::uint64_t>& bits, std::size_t point) { return bits[point / 64] >> (point % 64) & 1u; }

/// Share of each surface point in what a candidate sees: equal areas, so every seen point has the same.
double seenCount(const std::vector<std::uint64_t>& bits) {
  double count = 0.0;
  for (const std::uint64_t word : bits) count += std::popcount(word);
  return count;
}

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

/// The candidates nearest to one, for stability: HEALPix pixels have eight neighbours at most.
constexpr std::size_t neighbourCount = 8;

/// Pixels kept at each level of the refinement for C1 and for C2: from 48 through four levels, at most 272 images.
constexpr std::size_t keptPerLevel = 7;
/// Images of a refinement in all; what its levels leave is for climbing at the end.
constexpr std::size_t mostImages = 299;

/// The eight pixels around one, and itself, among the directions of a resolution.
std::vector<long> pixelsAround(const std::vector<glm::dvec3>& directions, glm::dvec3 centre) {
  std::vector<long> order(directions.size());
  std::iota(order.begin(), order.end(), 0L);
  const auto nearer = [&](long a, long b) {
    const double da = glm::dot(directions[static_cast<std::size_t>(a)], centre);
    const double db = glm::dot(directions[static_cast<std::size_t>(b)], centre);
    return da != db ? da > db : a < b;
  };
  const std::size_t count = std::min<std::size_t>(neighbourCount + 1, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(), nearer);
  order.resize(count);
  return order;
}

}  // namespace

Descriptors describe(const ImageSums& sums, int side, glm::dvec3 direction) {
  Descriptors d;
  const glm::dvec3 size = glm::abs(direction);
  d.orientation = std::max({size.x, size.y, size.z});
  if (sums.count <= 0.0) return d;
  d.visibility = sums.depth / sums.count;
  d.coverage = sums.count / (static_cast<double>(side) * side);
  d.location = 1.0 - std::min(1.0, glm::length(sums.position / sums.count) / std::numbers::sqrt2);
  return d;
}

void describeTogether(std::vector<Candidate>& candidates, std::size_t points) {
  if (points < 2) return;
  // p(o), averaged over the candidates that see anything.
  std::vector<double> mean(points, 0.0);
  double seeing = 0.0;
  for (const Candidate& candidate : candidates) {
    const double count = seenCount(candidate.seen);
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
    const double count = seenCount(candidate.seen);
    if (count == 0.0) continue;
    candidate.descriptors.entropy = std::log(count) / std::log(static_cast<double>(points));
    for (std::size_t o = 0; o < points; ++o)
      if (sees(candidate.seen, o)) information[v] += std::log(seeing / (count * mean[o])) / count;
    greatest = std::max(greatest, information[v]);
  }
  for (std::size_t v = 0; v < candidates.size(); ++v)
    if (seenCount(candidates[v].seen) > 0.0)
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
         w.mutualInformation * d.mutualInformation + w.stability * d.stability + w.orientation * d.orientation;
}

Camera::Axes axesAt(glm::dvec3 direction) {
  Camera camera;
  camera.target = glm::dvec3(0.0);
  camera.eye = direction;
  camera.up = {0.0, 0.0, 1.0};
  return camera.axes();
}

bool inRegion(glm::dvec3 c1, glm::dvec3 c2, const Options& options) {
  // Directions on the very rim belong to the region: rounding must not drop a standard view.
  constexpr double rim = 1e-9;
  const double along = std::abs(glm::dot(c1, c2));
  if (options.region == Region::Stream) return along <= std::sin(glm::radians(options.streamHalfWidth)) + rim;
  return along <= std::sqrt(0.5) + rim && glm::dot(c2, axesAt(c1).right) >= -rim;
}

std::optional<std::size_t> bestView(const std::vector<Candidate>& candidates, const Options& options) {
  std::optional<std::size_t> best;
  double greatest = 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].sums.count <= 0.0) continue;
    const double q = quality(candidates[i].descriptors, options.weights);
    if (best && q <= greatest) continue;
    best = i;
    greatest = q;
  }
  return best;
}

std::optional<std::size_t> dualView(const std::vector<Candidate>& candidates, glm::dvec3 c1, const Options& options) {
  std::optional<std::size_t> best;
  double greatest = 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].sums.count <= 0.0 || !inRegion(c1, candidates[i].direction, options)) continue;
    const double q = quality(candidates[i].descriptors, options.weights);
    if (best && q <= greatest) continue;
    best = i;
    greatest = q;
  }
  return best;
}

double seenShare(const Candidate& a, const Candidate& b, std::size_t points) {
  if (points == 0) return 0.0;
  std::size_t count = 0;
  for (std::size_t word = 0; word < a.seen.size(); ++word)
    count += static_cast<std::size_t>(std::popcount(a.seen[word] | b.seen[word]));
  return static_cast<double>(count) / static_cast<double>(points);
}

std::optional<Pair> jointSearch(const std::vector<Candidate>& candidates, std::size_t points, const Options& options) {
  std::optional<Pair> best;
  double greatest = 0.0, greatestQuality = 0.0;
  std::vector<double> q(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) q[i] = quality(candidates[i].descriptors, options.weights);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].sums.count <= 0.0) continue;
    for (std::size_t j = 0; j < candidates.size(); ++j) {
      if (j == i || candidates[j].sums.count <= 0.0) continue;
      if (!inRegion(candidates[i].direction, candidates[j].direction, options)) continue;
      const double share = seenShare(candidates[i], candidates[j], points), mean = 0.5 * (q[i] + q[j]);
      const double value = options.shareWeight * share + (1.0 - options.shareWeight) * mean;
      if (best && (value < greatest || (value == greatest && mean <= greatestQuality))) continue;
      best = Pair{i, j, share};
      greatest = value;
      greatestQuality = mean;
    }
  }
  // The relation of the two is the same from either side, but C1 is the better view.
  if (best && q[best->c2] > q[best->c1] &&
      inRegion(candidates[best->c2].direction, candidates[best->c1].direction, options))
    std::swap(best->c1, best->c2);
  return best;
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

Refined refine(const Evaluate& evaluate, const Options& options, int start, int finest) {
  const auto pixelsOf = [](int nside) {
    std::vector<long> pixels(static_cast<std::size_t>(12) * static_cast<std::size_t>(nside) *
                             static_cast<std::size_t>(nside));
    std::iota(pixels.begin(), pixels.end(), 0L);
    return pixels;
  };
  const auto directionsOf = [](int nside, const std::vector<long>& wanted) {
    std::vector<glm::dvec3> directions;
    for (const long pixel : wanted) directions.push_back(nestedDirection(nside, pixel));
    return directions;
  };
  std::vector<long> pixels = pixelsOf(start);
  std::vector<Candidate> level = evaluate(directionsOf(start, pixels)), all = level;
  // Positions in `level` of the best that are admitted, best first.
  const auto bestOf = [&](std::size_t most, const std::function<bool(const Candidate&)>& admitted) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < level.size(); ++i)
      if (level[i].sums.count > 0.0 && admitted(level[i])) order.push_back(i);
    const std::size_t count = std::min(most, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](std::size_t a, std::size_t b) {
                        const double qa = quality(level[a].descriptors, options.weights);
                        const double qb = quality(level[b].descriptors, options.weights);
                        return qa != qb ? qa > qb : pixels[a] < pixels[b];
                      });
    order.resize(count);
    return order;
  };
  const auto anywhere = [](const Candidate&) { return true; };

  int nside = start;
  for (; nside < finest; nside *= 2) {
    // The pixels of this level that C1 or C2 most likely lie in.
    const std::optional<std::size_t> c1 = bestView(all, options);
    if (!c1) return {all, 0};
    const glm::dvec3 direction = all[*c1].direction;
    std::set<long> kept;
    for (const std::size_t i : bestOf(keptPerLevel, anywhere)) kept.insert(pixels[i]);
    for (const std::size_t i : bestOf(keptPerLevel, [&](const Candidate& candidate) {
           return inRegion(direction, candidate.direction, options);
         }))
      kept.insert(pixels[i]);
    pixels.clear();
    for (const long pixel : kept)
      for (long child = 4 * pixel; child < 4 * pixel + 4; ++child) pixels.push_back(child);
    level = evaluate(directionsOf(2 * nside, pixels));
    all.insert(all.end(), level.begin(), level.end());
  }

  const std::size_t coarser = all.size() - level.size();
  // A maximum may lie across the edge of a pixel that was kept: climb from the best two, of the region and of all,
  // until they are better than all around them.
  const std::vector<glm::dvec3> finestDirections = directionsOf(nside, pixelsOf(nside));
  while (all.size() < mostImages) {
    const std::vector<std::size_t> best = bestOf(2, anywhere);
    if (best.empty()) break;
    const glm::dvec3 direction = level[best.front()].direction;
    std::vector<std::size_t> centres{best.front()};
    const std::vector<std::size_t> dual =
        bestOf(2, [&](const Candidate& candidate) { return inRegion(direction, candidate.direction, options); });
    centres.insert(centres.end(), dual.begin(), dual.end());
    centres.insert(centres.end(), best.begin(), best.end());
    std::vector<long> fresh;
    for (const std::size_t centre : centres) {
      for (const long pixel : pixelsAround(finestDirections, level[centre].direction))
        if (std::find(pixels.begin(), pixels.end(), pixel) == pixels.end()) fresh.push_back(pixel);
      if (!fresh.empty()) break;
    }
    if (fresh.empty()) break;
    fresh.resize(std::min(fresh.size(), mostImages - all.size()));
    const std::vector<Candidate> measured = evaluate(directionsOf(nside, fresh));
    pixels.insert(pixels.end(), fresh.begin(), fresh.end());
    level.insert(level.end(), measured.begin(), measured.end());
    all.insert(all.end(), measured.begin(), measured.end());
  }
  return {std::move(all), coarser};
}

}  // namespace fenestra::placement
