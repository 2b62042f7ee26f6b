#include "rendering/viewpoints/Refinement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>

#include "rendering/viewpoints/Sphere.h"

namespace fenestra::placement {
namespace {

/// Pixels of a level that are measured for their predicted quality. On 23 structures with seven choices of weights and
/// region each, this many find the C1 of an exhaustive search in all 161 cases and its C2 in all but three.
constexpr std::size_t promisingCount = 24;
/// How many of the finest level's best views are measured from the opposite side, too: the second of two nearly equal
/// views may have the better opposite.
constexpr std::size_t turned = 4;

/// The pixels at most `steps` steps from neighbour to neighbour away from one, without itself; in ascending order.
std::vector<int> pixelsAround(int nside, int pixel, int steps) {
  std::set<int> around{pixel};
  for (int step = 0; step < steps; ++step)
    for (const int inner : std::vector(around.begin(), around.end()))
      for (const int neighbour : nestedNeighbours(nside, inner)) around.insert(neighbour);
  around.erase(pixel);
  return {around.begin(), around.end()};
}

}  // namespace

Refinement::Refinement(const Options& options, std::size_t points, int start, int finest)
    : options_(options), points_(points), start_(start), finest_(finest) {
  plan();
}

void Refinement::add(const std::vector<Candidate>& measured) {
  for (std::size_t i = 0; i < wantedPixels_.size(); ++i) known_[wantedPixels_[i]] = measured.at(i);
  const Weights& weights = options_.weights;
  if (weights.entropy != 0.0 || weights.mutualInformation != 0.0 || weights.stability != 0.0) {
    std::vector<Candidate> all = candidates();
    describeTogether(all, points_);
    auto next = all.begin();
    for (auto& [pixel, candidate] : known_) candidate.descriptors = (next++)->descriptors;
  }
  plan();
}

double Refinement::progress() const {
  return wanted_.empty() ? 1.0 : static_cast<double>(known_.size()) / static_cast<double>(mostImages);
}

std::vector<Candidate> Refinement::candidates() const {
  std::vector<Candidate> all;
  for (const auto& [pixel, candidate] : known_) all.push_back(candidate);  // coarser levels first
  return all;
}

std::size_t Refinement::coarser() const {
  return static_cast<std::size_t>(std::distance(known_.begin(), known_.lower_bound({finest_, 0})));
}

/// Repeats the search on the measured pixels until it needs another one. That is quick, and no state is kept.
void Refinement::plan() {
  wantedPixels_.clear();
  wanted_.clear();
  std::vector<int> all(static_cast<std::size_t>(12 * start_ * start_));
  std::iota(all.begin(), all.end(), 0);
  if (!have(start_, all) || !descend({})) return;
  std::vector<int> opposites = ranked(finest_, {});
  if (opposites.empty()) return;
  opposites.resize(std::min(opposites.size(), turned));
  for (int& pixel : opposites) pixel = nestedPixel(finest_, -nestedDirection(finest_, pixel));
  if (!have(finest_, opposites) || !climb(finest_, {})) return;
  descend(nestedDirection(finest_, ranked(finest_, {}).front()));
}

bool Refinement::have(int nside, const std::vector<int>& pixels) {
  for (const int index : pixels)
    if (!known_.contains({nside, index}) && known_.size() + wanted_.size() < mostImages) {
      wantedPixels_.push_back({nside, index});
      wanted_.push_back(nestedDirection(nside, index));
    }
  return wanted_.empty();
}

bool Refinement::descend(const std::optional<glm::dvec3>& c1) {
  for (int nside = 2 * start_; nside <= finest_; nside *= 2)
    if (!have(nside, promising(nside, c1)) || !climb(nside, c1)) return false;
  return true;
}

std::vector<int> Refinement::promising(int nside, const std::optional<glm::dvec3>& c1) const {
  const CutEndRule rule = ruleFor(c1);
  std::vector<std::tuple<bool, double, int>> promises;  // admitted, how good
  for (const int parent : ranked(nside / 2, c1))
    for (int pixel = 4 * parent; pixel < 4 * parent + 4; ++pixel) {
      if (c1 && !mayHold({nside, pixel}, *c1)) continue;
      const double promise = promiseOf({nside, pixel}, c1);
      // The pixel itself is not measured yet.
      const bool isAdmitted = admits(rule, {nside / 2, parent});
      // Opposite views have the same outline in parallel projection: for C1 only the better side is followed.
      const Pixel opposite{nside, nestedPixel(nside, -nestedDirection(nside, pixel))};
      const Pixel behind{nside / 2, opposite.index / 4};
      if (!c1 && known_.contains(behind) && admits(rule, behind) >= isAdmitted && promiseOf(opposite, c1) > promise)
        continue;
      promises.emplace_back(isAdmitted, promise, pixel);
    }
  std::stable_sort(promises.begin(), promises.end(), [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) > std::tie(std::get<0>(b), std::get<1>(b));
  });
  promises.resize(std::min(promises.size(), promisingCount));
  std::vector<int> pixels;
  for (const auto& [isAdmitted, promise, pixel] : promises) pixels.push_back(pixel);
  return pixels;
}

double Refinement::promiseOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const {
  const glm::dvec3 place = placeOf(pixel, c1);
  const int coarser = pixel.nside / 2;
  // Fits the quality around `place` as a linear function of the direction by weighted least squares. A measured pixel's
  // weight is 1/e at the distance of one pixel's width.
  const double width = std::sqrt(std::numbers::pi / 3.0) / coarser;
  glm::dmat4 normal(1e-9);  // regularises: a slope that too few pixels determine is 0
  glm::dvec4 right(0.0);
  const auto end = known_.lower_bound({coarser + 1, 0});
  for (auto known = known_.lower_bound({coarser, 0}); known != end; ++known) {
    const glm::dvec3 away = (known->second.direction - place) / width;
    const glm::dvec4 row(1.0, away);
    const double weight = std::exp(-glm::dot(away, away));
    normal += weight * glm::outerProduct(row, row);
    right += weight * worth(known->second.descriptors, options_) * row;
  }
  return (glm::inverse(normal) * right).x;
}

glm::dvec3 Refinement::placeOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const {
  const glm::dvec3 middle = nestedDirection(pixel.nside, pixel.index);
  if (!c1 || inRegion(*c1, middle, options_)) return middle;
  glm::dvec3 nearest = middle;
  double cosine = -1.0;
  const int finer = (finest_ / pixel.nside) * (finest_ / pixel.nside);
  for (int fine = finer * pixel.index; fine < finer * (pixel.index + 1); ++fine) {
    const glm::dvec3 direction = nestedDirection(finest_, fine);
    if (glm::dot(direction, middle) <= cosine || !inRegion(*c1, direction, options_)) continue;
    nearest = direction;
    cosine = glm::dot(direction, middle);
  }
  return nearest;
}

bool Refinement::climb(int nside, const std::optional<glm::dvec3>& c1) {
  const std::vector<int> best = ranked(nside, c1);
  if (best.empty()) return true;
  const auto outside = [&](int pixel) { return c1 && !mayHold({nside, pixel}, *c1); };
  std::vector<int> around = pixelsAround(nside, best.front(), 1);
  // On the region's rim qualities also vary with how near to it a pixel's centre lies: search farther.
  constexpr int rimSteps = 3;
  if (nside == finest_ && std::any_of(around.begin(), around.end(), outside))
    around = pixelsAround(nside, best.front(), rimSteps);
  std::erase_if(around, outside);
  return have(nside, around);
}

std::vector<int> Refinement::ranked(int nside, const std::optional<glm::dvec3>& c1) const {
  std::vector<int> pixels;
  const auto end = known_.lower_bound({nside + 1, 0});
  for (auto at = known_.lower_bound({nside, 0}); at != end; ++at)
    if (at->second.sums.count > 0.0 && (!c1 || mayHold(at->first, *c1))) pixels.push_back(at->first.index);
  const CutEndRule rule = ruleFor(c1);
  const auto order = [&](int pixel) {
    return std::pair(admits(rule, {nside, pixel}), worth(known_.at({nside, pixel}).descriptors, options_));
  };
  std::stable_sort(pixels.begin(), pixels.end(), [&](int a, int b) { return order(a) > order(b); });
  return pixels;
}

bool Refinement::mayHold(Pixel pixel, glm::dvec3 c1) const {
  if (pixel.nside >= finest_) return inRegion(c1, nestedDirection(pixel.nside, pixel.index), options_);
  for (int child = 4 * pixel.index; child < 4 * pixel.index + 4; ++child)
    if (mayHold({2 * pixel.nside, child}, c1)) return true;
  return false;
}

CutEndRule Refinement::ruleFor(const std::optional<glm::dvec3>& c1) const {
  CutEndRule rule(options_.habits);
  for (const auto& [pixel, candidate] : known_)
    if (candidate.sums.count > 0.0 && (!c1 || inRegion(*c1, candidate.direction, options_)))
      rule.add(candidate.descriptors.awkwardness, seenPoints(candidate));
  return rule;
}

bool Refinement::admits(const CutEndRule& rule, Pixel pixel) const {
  const Candidate& candidate = known_.at(pixel);
  return rule.admits(candidate.descriptors.awkwardness, seenPoints(candidate));
}

}  // namespace fenestra::placement
