#include "rendering/segmentation/TubeSection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/VoxelBox.h"

namespace fenestra::segmentation {
namespace {

constexpr int rayCount = TubeSection::rays;
constexpr double betweenRays = 2.0 * std::numbers::pi / rayCount;

// Chosen on the aorta and the inferior vena cava of growing.md's torso, as all constants of tubes.
constexpr double largestRadius = 25.0;     ///< mm, the aorta's with room
constexpr int mostSamples = 64;            ///< on a ray
constexpr double sampleSides = 1.0 / 3.0;  ///< samples are this many voxel sides apart …
constexpr double leastStep = 0.5;          ///< … and as many mm at least
constexpr double windowSides = 0.8;        ///< voxel sides on either side of a wall that are compared …
constexpr double leastWindow = 1.0;        ///< … and mm at least
constexpr double seenRise = 1.2;           ///< units of the noise: a wall with less is not seen
constexpr double expectedWeight = 0.6;     ///< of the square of the difference from the expected radius, over that
constexpr double unevenWeight = 0.08;      ///< of the square of the contour's slope
constexpr double unlikeWeight = 0.5;       ///< of values within a contour that are not the tube's
constexpr double likeWithin = 1.2;         ///< units of the noise: values of the tube differ by this much on average
constexpr double ownRadiusSides = 1.5, leastOwnRadius = 2.0;  ///< voxel sides, mm: of the ball whose values are own
constexpr double mostNoise = 2.0;  ///< differences that the eye tells apart: what varies more is no noise
constexpr int reach = 3;           ///< samples that the contour may go in or out from ray to ray

glm::dvec2 onRay(int ray, double radius) {
  return radius * glm::dvec2(std::cos(betweenRays * ray), std::sin(betweenRays * ray));
}

/// The real value at a continuous index, trilinear; the volume's edge is repeated beyond it.
template <class Values>
double valueAt(const Volume& volume, const Values& values, glm::dvec3 index) {
  const glm::ivec3 dims = volume.grid.dims;
  index = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(dims - 1));
  const glm::ivec3 low = glm::max(glm::min(glm::ivec3(index), dims - 2), glm::ivec3(0));
  const glm::dvec3 share = index - glm::dvec3(low);
  const glm::ivec3 next = glm::min(glm::ivec3(1), dims - 1);
  const auto row = [&](int y, int z) {
    const std::size_t at = volume.grid.offset(low + glm::ivec3(0, y * next.y, z * next.z));
    const double a = finiteValue(values[at], volume);
    const double b = finiteValue(values[at + static_cast<std::size_t>(next.x)], volume);
    return a + (b - a) * share.x;
  };
  const auto mix = [](double a, double b, double of) { return a + (b - a) * of; };
  return mix(mix(row(0, 0), row(1, 0), share.y), mix(row(0, 1), row(1, 1), share.y), share.z);
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double TubeSection::area() const {
  double twice = 0.0;
  for (std::size_t ray = 0; ray < rayCount; ++ray) twice += contour[ray] * contour[(ray + 1) % rayCount];
  return 0.5 * twice * std::sin(betweenRays);
}

double TubeSection::radius() const { return std::sqrt(area() / std::numbers::pi); }

glm::dvec3 TubeSection::middle() const {
  glm::dvec2 sum(0.0);
  double twice = 0.0;
  for (int ray = 0; ray < rayCount; ++ray) {
    const glm::dvec2 a = onRay(ray, contour[static_cast<std::size_t>(ray)]);
    const glm::dvec2 b = onRay(ray + 1, contour[static_cast<std::size_t>((ray + 1) % rayCount)]);
    const double cross = a.x * b.y - b.x * a.y;
    twice += cross;
    sum += (a + b) * cross;
  }
  sum /= 3.0 * twice;
  return centre + sum.x * right + sum.y * up;
}

double TubeSection::aspect() const {
  double twice = 0.0;
  glm::dvec2 first(0.0);
  glm::dmat2 second(0.0);
  for (int ray = 0; ray < rayCount; ++ray) {
    const glm::dvec2 a = onRay(ray, wall[static_cast<std::size_t>(ray)]);
    const glm::dvec2 b = onRay(ray + 1, wall[static_cast<std::size_t>((ray + 1) % rayCount)]);
    const double cross = a.x * b.y - b.x * a.y;
    twice += cross;
    first += (a + b) * cross;
    second += (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(a + b, a + b)) * cross;
  }
  if (!(twice > 0.0)) return std::numeric_limits<double>::infinity();
  first /= 3.0 * twice;
  second = second / (12.0 * twice) - glm::outerProduct(first, first);
  const double mean = 0.5 * (second[0][0] + second[1][1]);
  const double apart = std::hypot(0.5 * (second[0][0] - second[1][1]), second[0][1]);
  return mean > apart ? std::sqrt((mean + apart) / (mean - apart)) : std::numeric_limits<double>::infinity();
}

TubeSection::Radii TubeSection::contourFrom(glm::dvec3 point) const {
  const glm::dvec2 away(glm::dot(point - centre, right), glm::dot(point - centre, up));
  Radii radii;
  for (int ray = 0; ray < rayCount; ++ray) {
    const auto at = static_cast<std::size_t>(ray);
    radii[at] = std::max(0.1 * contour[at], contour[at] - glm::dot(away, onRay(ray, 1.0)));
  }
  return radii;
}

TubeSection TubeSection::reversed() const {
  TubeSection turned = *this;
  turned.normal = -normal;
  turned.up = -up;
  for (std::size_t ray = 0; ray < rayCount; ++ray) {
    turned.contour[ray] = contour[(rayCount - ray) % rayCount];
    turned.wall[ray] = wall[(rayCount - ray) % rayCount];
  }
  return turned;
}

TubeSection TubeSection::movedTo(glm::dvec3 to, glm::dvec3 along) const {
  TubeSection moved = *this;
  moved.centre = to;
  moved.normal = along;
  moved.right = glm::normalize(right - glm::dot(right, along) * along);
  moved.up = glm::cross(along, moved.right);
  return moved;
}

SectionFinder::SectionFinder(const Volume& volume, const Noise& noise, glm::ivec3 seed)
    : volume_(volume),
      toIndex_(volume.grid.indexFromWorld()),
      side_(voxelSide(volume.grid)),
      step_(std::max(leastStep, sampleSides * side_)),
      most_(std::min(mostSamples, static_cast<int>(segmentation::largestRadius / step_))),
      count_(most_),
      window_(std::max(1, static_cast<int>(std::lround(std::max(windowSides * side_, leastWindow) / step_)))) {
  const VoxelBox whole = wholeOf(volume.grid.dims);
  std::vector<double> values;
  volume.voxels.visit([&](auto stored) {
    for (const glm::ivec3 offset : ballOffsets(volume.grid, std::max(ownRadiusSides * side_, leastOwnRadius)))
      if (whole.contains(seed + offset)) values.push_back(finiteValue(stored[whole.offset(seed + offset)], volume));
  });
  own_ = median(values);
  for (double& value : values) value = std::abs(value - own_);
  constexpr double normal = 1.48;  // the deviation over the median of the differences, of normal noise
  const double noisy = std::max(noise.deviation, noise.seen);
  unit_ = std::max(noisy, std::min(normal * median(values), mostNoise * noise.seen));
}

bool SectionFinder::contains(glm::dvec3 point) const {
  const glm::dvec3 index(toIndex_ * glm::dvec4(point, 1.0));
  return glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) &&
         glm::all(glm::lessThan(index, glm::dvec3(volume_.grid.dims) - 0.5));
}

void SectionFinder::sample(const TubeSection& plane, const TubeSection::Radii* expected) {
  count_ = most_;
  if (expected) {
    const double farthest = *std::max_element(expected->begin(), expected->end());
    count_ = std::min(most_, static_cast<int>(2.0 * farthest / step_) + 2 * window_);
  }
  apart_.resize(static_cast<std::size_t>(rayCount * count_));
  const glm::dvec3 centre(toIndex_ * glm::dvec4(plane.centre, 1.0));
  volume_.voxels.visit([&](auto stored) {
    std::size_t at = 0;
    for (int ray = 0; ray < rayCount; ++ray) {
      const glm::dvec2 on = onRay(ray, step_);
      const glm::dvec3 along(toIndex_ * glm::dvec4(on.x * plane.right + on.y * plane.up, 0.0));
      for (int place = 0; place < count_; ++place, ++at)
        apart_[at] =
            static_cast<float>(std::abs(valueAt(volume_, stored, centre + (place + 0.5) * along) - own_) / unit_);
    }
  });
}

void SectionFinder::rate(const TubeSection::Radii* expected) {
  rises_.resize(apart_.size());
  scores_.resize(apart_.size());
  std::vector<double> sums(static_cast<std::size_t>(count_) + 1, 0.0);
  const auto mean = [&](int begin, int end) {
    return (sums[static_cast<std::size_t>(end)] - sums[static_cast<std::size_t>(begin)]) / (end - begin);
  };
  for (int ray = 0; ray < rayCount; ++ray) {
    for (int place = 0; place < count_; ++place)
      sums[static_cast<std::size_t>(place) + 1] =
          sums[static_cast<std::size_t>(place)] + std::min(mostRise, apart(ray, place));
    for (int place = 0; place < count_; ++place) {
      const int end = place + 1, farthest = std::min(count_, end + window_);
      const double within = mean(std::max(0, end - window_), end);
      const double rise = farthest > end ? mean(end, farthest) - within : 0.0;
      double rating = (rise - unlikeWeight * std::max(0.0, mean(0, end) - likeWithin)) / mostRise;
      if (expected) {
        const double radius = (*expected)[static_cast<std::size_t>(ray)];
        const double off = (radiusAt(place) - radius) / std::max(radius, 2.0 * side_);
        rating -= expectedWeight * off * off;
      }
      rises_[static_cast<std::size_t>(ray * count_ + place)] = static_cast<float>(rise);
      score(ray, place) = static_cast<float>(rating);
    }
  }
}

/// Goes round three times: what was chosen in the second round depends neither on where it began nor on where it ends.
std::array<int, rayCount> SectionFinder::bestContour() {
  constexpr int turns = 3 * rayCount;
  const auto count = static_cast<std::size_t>(count_);
  sums_.assign(scores_.begin(), scores_.begin() + count_);
  next_.resize(count);
  origins_.resize(static_cast<std::size_t>(turns) * count);
  for (int turn = 1; turn < turns; ++turn) {
    const int ray = turn % rayCount;
    for (int place = 0; place < count_; ++place) {
      const double unit = step_ / (std::max(radiusAt(place), 2.0 * side_) * betweenRays);
      const auto price = static_cast<float>(unevenWeight * unit * unit);
      float best = -1e9f;
      int from = 0;
      for (int by = std::max(-reach, -place); by <= std::min(reach, count_ - 1 - place); ++by) {
        const float sum = sums_[static_cast<std::size_t>(place + by)] - price * static_cast<float>(by * by);
        if (sum > best) {
          best = sum;
          from = by;
        }
      }
      next_[static_cast<std::size_t>(place)] = best + score(ray, place);
      origins_[static_cast<std::size_t>(turn) * count + static_cast<std::size_t>(place)] =
          static_cast<signed char>(from);
    }
    std::swap(sums_, next_);
  }
  std::array<int, rayCount> places{};
  auto place = static_cast<int>(std::max_element(sums_.begin(), sums_.end()) - sums_.begin());
  for (int turn = turns - 1; turn >= rayCount; --turn) {
    if (turn < 2 * rayCount) places[static_cast<std::size_t>(turn % rayCount)] = place;
    place += origins_[static_cast<std::size_t>(turn) * count + static_cast<std::size_t>(place)];
  }
  return places;
}

/// mm: where the difference from the tube's value is half of what it is beyond the wall. A blurred wall seems to begin
/// too early where a difference of a few units of the noise is as good as the greatest.
double SectionFinder::wallAt(int ray, int place) const {
  int beyond = place;
  for (int other = place; other < std::min(count_, place + 2 * window_ + 1); ++other)
    if (apart(ray, other) > apart(ray, beyond)) beyond = other;
  const double half = 0.5 * apart(ray, beyond);
  if (half < 1.0) return radiusAt(place);
  const int first = std::max(0, place - window_);
  int outer = beyond;
  while (outer > first && apart(ray, outer - 1) > half) --outer;
  const double inner = outer > 0 ? apart(ray, outer - 1) : 0.0;
  const double share =
      apart(ray, outer) > inner ? std::clamp((half - inner) / (apart(ray, outer) - inner), 0.0, 1.0) : 1.0;
  return std::clamp((outer - 0.5 + share) * step_, radiusAt(place) - window_ * step_,
                    radiusAt(place) + 2 * window_ * step_);
}

TubeSection SectionFinder::find(const TubeSection& plane, const TubeSection::Radii* expected) {
  sample(plane, expected);
  rate(expected);
  const std::array<int, rayCount> places = bestContour();
  TubeSection section = plane;
  section.rise = section.support = section.unlike = 0.0;
  double weights = 0.0;
  for (int ray = 0; ray < rayCount; ++ray) {
    const auto at = static_cast<std::size_t>(ray);
    const int place = places[at];
    section.contour[at] = radiusAt(place);
    section.wall[at] = wallAt(ray, place);
    const double rise = rises_[static_cast<std::size_t>(ray * count_ + place)];
    section.rise += rise / rayCount;
    section.support += (rise >= seenRise ? 1.0 : 0.0) / rayCount;
    for (int within = 0; within <= place; ++within) {
      section.unlike += std::min(mostRise, apart(ray, within)) * (within + 0.5);  // as much as its ring's area
      weights += within + 0.5;
    }
  }
  section.unlike /= weights;
  return section;
}

TubeSection SectionFinder::centred(const TubeSection& plane, const TubeSection::Radii* expected, int rounds) {
  TubeSection section = find(plane, expected);
  TubeSection from = plane;
  if (expected) from.contour = *expected;
  for (int round = 0; round < rounds; ++round) {
    const glm::dvec3 middle = section.middle();
    if (glm::length(middle - section.centre) < 0.25 * step_) break;
    const TubeSection::Radii moved = from.contourFrom(middle);
    from.centre = middle;
    from.contour = moved;
    section = find(from, expected ? &moved : nullptr);
  }
  return section;
}

}  // namespace fenestra::segmentation
