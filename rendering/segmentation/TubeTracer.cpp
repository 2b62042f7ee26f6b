#include "rendering/segmentation/TubeTracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rendering/segmentation/Morphology.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr int rays = TubeSection::rays;

// Chosen as the constants of TubeSection.cpp.
constexpr int directions = 48;         ///< of planes at the seed, over half a sphere
constexpr double leastSupport = 0.55;  ///< of a section
constexpr double mostUnlike = 2.0;     ///< units of the noise
constexpr double fullReach = 0.8;      ///< of the largest radius: a larger section may be cut by the rays' ends
constexpr std::size_t candidates = 4;  ///< planes at the seed that are followed
constexpr double sameDirection = 0.9;  ///< cosine
// What speaks for a plane and for a tube, and what against.
constexpr double riseWeight = 2.0, supportWeight = 1.0, wideWeight = 0.4;
constexpr double longEnough = 5.0;                    ///< diameters: a longer tube is no better
constexpr double stepShare = 0.3, longestStep = 6.0;  ///< of the radius; mm
constexpr std::size_t mostSections = 400;             ///< one way
constexpr double widest = 1.35, narrowest = 0.7;      ///< of the radius so far
constexpr double followRadius = 0.1;    ///< share of a section in the radius so far: it forgets within three radii
constexpr int patience = 3;             ///< sections in a row that may fail: a branch leaves, a plaque casts a shadow
constexpr double chordRadii = 1.2;      ///< radii: the direction is that of the last middles over this length
constexpr double turnShare = 0.35;      ///< of the chord's direction in the next one
constexpr double steadyRadii = 2.0;     ///< radii from the seed: the direction is that of the tube
constexpr double leastDiameters = 2.0;  ///< of length: less is no tube
constexpr double overlap = 0.6;         ///< of the distance between sections, on either side: no gap in a bend
constexpr double thickest = 1.5;        ///< of the radius

/// Directions spread evenly over half a sphere (golden spiral).
glm::dvec3 directionAt(int number) {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double z = (number + 0.5) / directions, across = std::sqrt(1.0 - z * z);
  return {across * std::cos(golden * number), across * std::sin(golden * number), z};
}

TubeSection planeAt(glm::dvec3 centre, glm::dvec3 normal) {
  TubeSection plane;
  plane.centre = centre;
  plane.normal = normal;
  plane.right =
      glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  plane.up = glm::cross(normal, plane.right);
  return plane;
}

class Tracer {
 public:
  Tracer(const Volume& volume, const Noise& noise, glm::ivec3 seed)
      : volume_(volume),
        finder_(volume, noise, seed),
        voxel_(seed),
        seed_(volume.grid.worldFromIndex() * glm::dvec4(glm::dvec3(seed), 1.0)) {}

  std::optional<Tube> run() {
    const std::vector<TubeSection> begun = starts();
    std::vector<Tube> tubes(begun.size());
    parallelFor(begun.size(), 1, [&](std::size_t first, std::size_t end) {
      SectionFinder finder = finder_;
      for (std::size_t i = first; i < end; ++i) tubes[i] = from(begun[i], finder);
    });
    const Tube* best = nullptr;
    double most = 0.0;
    for (const Tube& tube : tubes) {
      if (tube.diameters() < leastDiameters) continue;
      const double worth = riseWeight * tube.rise / SectionFinder::mostRise + supportWeight * tube.support +
                           std::log(std::min(longEnough, tube.diameters()));
      if (best && worth <= most) continue;
      most = worth;
      best = &tube;
    }
    if (!best) return std::nullopt;
    // On its way back the tube may end before the seed, where the seed's own plane had led on.
    Tube steady = steadied(*best);
    return segmentation::holds(tubeRegion(volume_, steady), voxel_) ? steady : *best;
  }

 private:
  /// The clearest and least sections at the seed, in planes that differ.
  std::vector<TubeSection> starts() {
    struct Rated {
      TubeSection section;
      double worth;
    };
    std::vector<Rated> all(directions);
    parallelFor(all.size(), 8, [&](std::size_t first, std::size_t end) {
      SectionFinder finder = finder_;
      for (std::size_t number = first; number < end; ++number) {
        const TubeSection section = finder.centred(planeAt(seed_, directionAt(static_cast<int>(number))), nullptr, 2);
        all[number] = {section, riseWeight * section.rise / SectionFinder::mostRise + supportWeight * section.support -
                                    wideWeight * std::log(section.radius())};
      }
    });
    std::erase_if(all, [&](const Rated& each) {
      return each.section.support < leastSupport || each.section.radius() > fullReach * finder_.largestRadius();
    });
    std::stable_sort(all.begin(), all.end(), [](const Rated& a, const Rated& b) { return a.worth > b.worth; });
    std::vector<TubeSection> chosen;
    for (const Rated& each : all) {
      const bool isNew = std::none_of(chosen.begin(), chosen.end(), [&](const TubeSection& other) {
        return std::abs(glm::dot(other.normal, each.section.normal)) > sameDirection;
      });
      if (isNew) chosen.push_back(each.section);
      if (chosen.size() == candidates) break;
    }
    return chosen;
  }

  static Tube from(const TubeSection& start, SectionFinder& finder) {
    return joined(start, way(start, finder), way(start.reversed(), finder));
  }

  /// The plane at the seed may be askew, beside a wall that is not seen, and lead astray on one side. So the tube is
  /// followed anew from a section on its longer side whose direction is that of the middles before it.
  Tube steadied(const Tube& tube) {
    const std::vector<TubeSection>& all = tube.sections;
    const bool isEarly = 2 * tube.start < all.size();  // most of it lies ahead of the seed
    const TubeSection& seed = all[tube.start];
    std::size_t at = tube.start;
    while ((isEarly ? at + 1 < all.size() : at > 0) &&
           glm::length(all[at].centre - seed.centre) < steadyRadii * seed.radius())
      isEarly ? ++at : --at;
    // Towards the seed and beyond it.
    const TubeSection start = isEarly ? all[at].reversed() : all[at];
    std::vector<TubeSection> back;  // what lies behind, looking away from it
    while (isEarly ? at + 1 < all.size() : at > 0) back.push_back(isEarly ? all[++at] : all[--at].reversed());
    return joined(start, way(start, finder_), back);
  }

  /// `back` leads away from the other side of `start`.
  static Tube joined(const TubeSection& start, const std::vector<TubeSection>& ahead,
                     const std::vector<TubeSection>& back) {
    Tube tube;
    for (std::size_t i = back.size(); i-- > 0;) tube.sections.push_back(back[i].reversed());
    tube.start = tube.sections.size();
    tube.sections.push_back(start);
    tube.sections.insert(tube.sections.end(), ahead.begin(), ahead.end());
    const auto count = static_cast<double>(tube.sections.size());
    std::vector<double> aspects;
    for (std::size_t i = 0; i < tube.sections.size(); ++i) {
      const TubeSection& each = tube.sections[i];
      tube.radius += each.radius() / count;
      tube.rise += each.rise / count;
      tube.support += each.support / count;
      aspects.push_back(each.aspect());
      if (i > 0) tube.length += glm::length(each.centre - tube.sections[i - 1].centre);
    }
    const auto middle = aspects.begin() + static_cast<std::ptrdiff_t>(aspects.size() / 2);
    std::nth_element(aspects.begin(), middle, aspects.end());
    tube.aspect = *middle;
    return tube;
  }

  /// The sections that follow a first one, which is not among them.
  static std::vector<TubeSection> way(const TubeSection& start, SectionFinder& finder) {
    std::vector<TubeSection> sections;
    std::vector<glm::dvec3> middles{start.centre};
    TubeSection last = start;
    glm::dvec3 along = start.normal;
    double radius = start.radius();
    int failed = 0;
    while (sections.size() < mostSections) {
      const double step = std::max(finder.side(), std::min(longestStep, stepShare * last.radius()));
      const glm::dvec3 next = last.centre + step * along;
      if (!finder.contains(next)) break;
      last = finder.centred(last.movedTo(next, along), &last.contour, 1);
      if (holds(last, radius, finder.largestRadius())) {
        failed = 0;
        radius *= std::pow(last.radius() / radius, followRadius);
      } else if (++failed == patience) {
        break;
      }
      sections.push_back(last);
      middles.push_back(last.centre);
      along = directionAfter(middles, along, last.radius());
    }
    for (int i = std::min(failed, patience - 1); i > 0; --i) sections.pop_back();
    return sections;
  }

  static bool holds(const TubeSection& section, double radius, double largest) {
    const double own = section.radius();
    return section.support >= leastSupport && section.unlike < mostUnlike && own <= widest * radius &&
           own >= narrowest * radius && own <= largest;
  }

  static glm::dvec3 directionAfter(const std::vector<glm::dvec3>& middles, glm::dvec3 along, double radius) {
    std::size_t begin = middles.size() - 1;
    while (begin > 0 && glm::length(middles.back() - middles[begin]) < chordRadii * radius) --begin;
    const glm::dvec3 chord = middles.back() - middles[begin];
    const double length = glm::length(chord);
    if (length == 0.0) return along;
    const double share = turnShare * std::min(1.0, length / (chordRadii * radius));
    return glm::normalize((1.0 - share) * along + share * chord / length);
  }

  const Volume& volume_;
  SectionFinder finder_;
  glm::ivec3 voxel_;
  glm::dvec3 seed_;
};

/// How far from the middle a point of a section's plane lies, in units of the wall's distance on that side.
double depthOf(const TubeSection& section, glm::dvec2 point) {
  double turn = std::atan2(point.y, point.x) * rays / (2.0 * std::numbers::pi);
  if (turn < 0.0) turn += rays;
  const double before = std::floor(turn);
  const auto ray = static_cast<std::size_t>(before) % rays;
  const double wall = section.wall[ray] + (section.wall[(ray + 1) % rays] - section.wall[ray]) * (turn - before);
  return glm::length(point) / wall;
}

}  // namespace

std::optional<Tube> traceTube(const Volume& volume, const Noise& noise, glm::ivec3 seed) {
  return Tracer(volume, noise, seed).run();
}

bool holds(const TubeRegion& tube, glm::ivec3 voxel) {
  return tube.box.contains(voxel) && tube.joins[tube.box.offset(voxel)] <= tubeLevel;
}

TubeRegion tubeRegion(const Volume& volume, const Tube& tube) {
  const Grid& grid = volume.grid;
  const VoxelBox whole = wholeOf(grid.dims);
  const glm::dmat4 toIndex = grid.indexFromWorld(), toWorld = grid.worldFromIndex();
  const std::vector<TubeSection>& sections = tube.sections;
  std::vector<double> halves(sections.size(), 0.5 * voxelSide(grid));
  std::vector<VoxelBox> boxes;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    for (const std::size_t other : {i > 0 ? i - 1 : i, std::min(i + 1, sections.size() - 1)})
      halves[i] = std::max(halves[i], overlap * glm::length(sections[i].centre - sections[other].centre));
    const double reach =
        std::hypot(thickest * *std::max_element(sections[i].wall.begin(), sections[i].wall.end()), halves[i]);
    glm::dvec3 extent(0.0);  // of a ball of that radius, in voxels
    for (int axis = 0; axis < 3; ++axis)
      extent[axis] = reach * glm::length(glm::dvec3(toIndex[0][axis], toIndex[1][axis], toIndex[2][axis]));
    const glm::dvec3 middle(toIndex * glm::dvec4(sections[i].centre, 1.0));
    boxes.push_back(
        VoxelBox{glm::ivec3(glm::floor(middle - extent)), glm::ivec3(glm::ceil(middle + extent)) + 1}.clippedTo(whole));
  }
  TubeRegion region{boxes.front(), {}, tube.aspect};
  for (const VoxelBox& box : boxes)
    region.box = {glm::min(region.box.low, box.low), glm::max(region.box.high, box.high)};
  region.joins.assign(region.box.count(), never);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const TubeSection& section = sections[i];
    for (std::size_t at = 0; at < boxes[i].count(); ++at) {
      const glm::ivec3 voxel = boxes[i].at(at);
      const glm::dvec3 away = glm::dvec3(toWorld * glm::dvec4(glm::dvec3(voxel), 1.0)) - section.centre;
      if (std::abs(glm::dot(away, section.normal)) > halves[i]) continue;
      const double depth = depthOf(section, {glm::dot(away, section.right), glm::dot(away, section.up)});
      if (depth > thickest) continue;
      Level& level = region.joins[region.box.offset(voxel)];
      level = std::min(level, static_cast<Level>(std::ceil(tubeLevel * depth)));
    }
  }
  return region;
}

}  // namespace fenestra::segmentation
