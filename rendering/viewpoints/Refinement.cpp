#include "rendering/viewpoints/Refinement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "rendering/viewpoints/Sphere.h"

namespace fenestra::placement {
namespace {

/// How many pixels of a level are looked at because they promise most. So many find the C1 that trying all finds for 23
/// structures by seven choices of weights and region, and but for three of these 161 the C2.
constexpr std::size_t promisingCount = 24;
/// Of the finest level's best, how many are looked at from the opposite side too: of two nearly equal outlines either
/// may be the better one from there.
constexpr std::size_t turned = 4;

/// The pixels around one: those met up to `reach` pixels' widths away from its middle.
std::vector<long> pixelsAround(int nside, long pixel, int reach) {
  constexpr int stepsPerWidth = 16;
  const glm::dvec3 centre = nestedDirection(nside, pixel);
  const Camera::Axes axes = axesAt(centre);
  std::set<long> around;
  for (int ring = 1; ring <= reach; ++ring) {
    const double away = ring * std::sqrt(std::numbers::pi / 3.0) / nside;
    for (int i = 0; i < ring * stepsPerWidth; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / (ring * stepsPerWidth);
      const glm::dvec3 aside = std::cos(angle) * axes.right + std::sin(angle) * axes.up;
      around.insert(nestedPixel(nside, std::cos(away) * centre + std::sin(away) * aside));
    }
  }
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

/// Goes through the whole search with what is known, up to where something is missing: quick, and no state to keep.
void Refinement::plan() {
  wantedPixels_.clear();
  wanted_.clear();
  std::vector<long> all(static_cast<std::size_t>(12 * start_ * start_));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<long>(i);
  if (!have(start_, all) || !descend({})) return;
  std::vector<long> opposites = ranked(finest_, {});
  if (opposites.empty()) return;
  opposites.resize(std::min(opposites.size(), turned));
  for (long& pixel : opposites) pixel = nestedPixel(finest_, -nestedDirection(finest_, pixel));
  if (!have(finest_, opposites) || !climb(finest_, {})) return;
  descend(nestedDirection(finest_, ranked(finest_, {}).front()));
}

bool Refinement::have(int nside, const std::vector<long>& pixels) {
  for (const long index : pixels)
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

std::vector<long> Refinement::promising(int nside, const std::optional<glm::dvec3>& c1) const {
  std::vector<std::pair<double, long>> promises;
  for (const long parent : ranked(nside / 2, c1))
    for (long pixel = 4 * parent; pixel < 4 * parent + 4; ++pixel) {
      if (c1 && !mayHold({nside, pixel}, *c1)) continue;
      const double promise = promiseOf({nside, pixel}, c1);
      // In parallel projection the opposite view has the same outline: of two sides the better one leads the way for
      // C1.
      const Pixel opposite{nside, nestedPixel(nside, -nestedDirection(nside, pixel))};
      if (!c1 && known_.contains({nside / 2, opposite.index / 4}) && promiseOf(opposite, c1) > promise) continue;
      promises.emplace_back(promise, pixel);
    }
  std::stable_sort(promises.begin(), promises.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  promises.resize(std::min(promises.size(), promisingCount));
  std::vector<long> pixels;
  for (const auto& [promise, pixel] : promises) pixels.push_back(pixel);
  return pixels;
}

double Refinement::promiseOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const {
  const glm::dvec3 place = placeOf(pixel, c1);
  const int coarser = pixel.nside / 2;
  // Quality around there as a linear function of the direction, by weighted least squares; a pixel's width away a known
  // one counts 1/e.
  const double width = std::sqrt(std::numbers::pi / 3.0) / coarser;
  glm::dmat4 normal(1e-9);  // where too few are known to tell a slope there is none
  glm::dvec4 right(0.0);
  const auto end = known_.lower_bound({coarser + 1, 0});
  for (auto known = known_.lower_bound({coarser, 0}); known != end; ++known) {
    const glm::dvec3 away = (known->second.direction - place) / width;
    const glm::dvec4 row(1.0, away);
    const double weight = std::exp(-glm::dot(away, away));
    normal += weight * glm::outerProduct(row, row);
    right += weight * quality(known->second.descriptors, options_.weights) * row;
  }
  return (glm::inverse(normal) * right).x;
}

glm::dvec3 Refinement::placeOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const {
  const glm::dvec3 middle = nestedDirection(pixel.nside, pixel.index);
  if (!c1 || inRegion(*c1, middle, options_)) return middle;
  glm::dvec3 nearest = middle;
  double cosine = -1.0;
  const long finer = static_cast<long>(finest_ / pixel.nside) * (finest_ / pixel.nside);
  for (long fine = finer * pixel.index; fine < finer * (pixel.index + 1); ++fine) {
    const glm::dvec3 direction = nestedDirection(finest_, fine);
    if (glm::dot(direction, middle) <= cosine || !inRegion(*c1, direction, options_)) continue;
    nearest = direction;
    cosine = glm::dot(direction, middle);
  }
  return nearest;
}

bool Refinement::climb(int nside, const std::optional<glm::dvec3>& c1) {
  const std::vector<long> best = ranked(nside, c1);
  if (best.empty()) return true;
  const auto outside = [&](long pixel) { return c1 && !mayHold({nside, pixel}, *c1); };
  std::vector<long> around = pixelsAround(nside, best.front(), 1);
  // Along the region's rim it also matters how near to that a pixel's middle happens to lie: look farther.
  constexpr int rimReach = 3;
  if (nside == finest_ && std::any_of(around.begin(), around.end(), outside))
    around = pixelsAround(nside, best.front(), rimReach);
  std::erase_if(around, outside);
  return have(nside, around);
}

std::vector<long> Refinement::ranked(int nside, const std::optional<glm::dvec3>& c1) const {
  std::vector<long> pixels;
  const auto end = known_.lower_bound({nside + 1, 0});
  for (auto at = known_.lower_bound({nside, 0}); at != end; ++at)
    if (at->second.sums.count > 0.0 && (!c1 || mayHold(at->first, *c1))) pixels.push_back(at->first.index);
  std::stable_sort(pixels.begin(), pixels.end(), [&](long a, long b) {
    return qualityAt({nside, a}) > qualityAt({nside, b});
  });
  return pixels;
}

bool Refinement::mayHold(Pixel pixel, glm::dvec3 c1) const {
  if (pixel.nside >= finest_) return inRegion(c1, nestedDirection(pixel.nside, pixel.index), options_);
  for (long child = 4 * pixel.index; child < 4 * pixel.index + 4; ++child)
    if (mayHold({2 * pixel.nside, child}, c1)) return true;
  return false;
}

double Refinement::qualityAt(Pixel pixel) const { return quality(known_.at(pixel).descriptors, options_.weights); }

}  // namespace fenestra::placement
