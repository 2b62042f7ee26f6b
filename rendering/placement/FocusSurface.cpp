#include "rendering/placement/FocusSurface.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <span>

#include "rendering/volume/Threads.h"

namespace fenestra::placement {
namespace {

/// A cell that the surface passes through.
struct Element {
  glm::ivec3 cell{0};         ///< its first corner's index
  unsigned corners = 0;       ///< bit i: corner i (x fastest) is in the focus
  double greatestArea = 0.0;  ///< mm²: upper bound of the surface's area in it
};

/// Which corners of cells are in the focus.
class Corners {
 public:
  Corners(const Scene& scene, const FocusIndex& index)
      : scene_(scene), index_(index), shown_(shownVolume(scene)), voxels_(shown_) {
    if (index.kind == FocusIndex::Kind::Values) range_ = std::get<ValueFocus>(scene.look.focus).values;
  }

  unsigned operator()(glm::ivec3 cell) const {
    const glm::ivec3 framed = cell + 1;
    const std::uint32_t slot = index_.slots[brickOffset(index_.bricks, framed / brickSide)];
    if (slot == 0) return 0;
    const std::size_t local = cellInBrick(framed);
    if (index_.kind == FocusIndex::Kind::Labels) {
      if (slot == 1) return 255;
      const std::size_t byte = (slot - 2) * cellsPerBrick + local;
      return (index_.cells[byte / 4] >> (8 * (byte % 4))) & 255u;
    }
    if (slot >= 2) {
      const std::size_t bit = (slot - 2) * cellsPerBrick + local;
      if (((index_.cells[bit / 32] >> (bit % 32)) & 1u) == 0) return 0;
    }
    unsigned corners = 0;
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 voxel = glm::min(cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2), scene_.volume->grid.dims - 1);
      const double value = voxels_.value(voxel);
      if (value >= range_.low && value <= range_.high) corners |= 1u << i;
    }
    return corners;
  }

  /// Whether a brick may hold cells that are partly in the focus.
  bool canCross(std::uint32_t slot) const {
    return slot >= 2 || (slot == 1 && index_.kind == FocusIndex::Kind::Values);
  }

 private:
  const Scene& scene_;
  const FocusIndex& index_;
  ShownVolume shown_;
  ShownVoxels voxels_;  ///< of shown_
  ValueRange range_;
};

/// Gradient of the trilinear indicator averaged over a cell, per index step; points into the focus.
glm::dvec3 gradientOf(unsigned corners) {
  glm::dvec3 gradient(0.0);
  for (int i = 0; i < 8; ++i)
    if (corners >> i & 1u)
      gradient += glm::dvec3((i & 1) ? 0.25 : -0.25, (i & 2) ? 0.25 : -0.25, (i & 4) ? 0.25 : -0.25);
  return gradient;
}

/// The indicator at a cell's corners, and its gradient averaged over the cell, per index step.
struct Level {
  double mean = 0.0;
  glm::dvec3 gradient{0.0};
};
Level levelIn(const Element& element, const SmoothedIndicator* smoothed) {
  if (!smoothed) return {0.125 * std::popcount(element.corners), gradientOf(element.corners)};
  std::array<std::uint16_t, 8> corners;
  smoothed->read(element.cell, glm::ivec3(2), corners.data());
  Level level;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double value = corners[i] / double{SmoothedIndicator::one};
    level.mean += 0.125 * value;
    level.gradient += 0.25 * value * glm::dvec3((i & 1u) ? 1 : -1, (i & 2u) ? 1 : -1, (i & 4u) ? 1 : -1);
  }
  return level;
}

/// Interleaves the bits of three numbers (Morton code), so that neighbours in space are near in the order.
std::uint64_t mortonCode(glm::ivec3 position) {
  std::uint64_t code = 0;
  for (int bit = 0; bit < 21; ++bit)
    for (int axis = 0; axis < 3; ++axis)
      code |= static_cast<std::uint64_t>((position[axis] >> bit) & 1) << (3 * bit + axis);
  return code;
}

/// All cells that the surface passes through, where `kept` keeps their middles, brick by brick in Morton order.
std::vector<Element> elementsOf(const Grid& grid, const FocusIndex& index, const Corners& cornersOf,
                                const std::vector<HalfSpace>& kept) {
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dmat3 worldFromIndexGradient = glm::transpose(glm::dmat3(grid.indexFromWorld()));
  const glm::ivec3 low = glm::max(index.box->low - 1, 0), high = glm::min(index.box->high, grid.dims - 2);
  const glm::ivec3 firstBrick = (low + 1) / brickSide, lastBrick = (high + 1) / brickSide;
  std::vector<glm::ivec3> bricks;
  for (int z = firstBrick.z; z <= lastBrick.z; ++z)
    for (int y = firstBrick.y; y <= lastBrick.y; ++y)
      for (int x = firstBrick.x; x <= lastBrick.x; ++x)
        if (cornersOf.canCross(index.slots[brickOffset(index.bricks, {x, y, z})])) bricks.emplace_back(x, y, z);
  std::sort(bricks.begin(), bricks.end(), [](glm::ivec3 a, glm::ivec3 b) { return mortonCode(a) < mortonCode(b); });

  std::vector<std::vector<Element>> perBrick(bricks.size());
  parallelFor(bricks.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const glm::ivec3 first = glm::max(bricks[b] * brickSide - 1, low);
      const glm::ivec3 last = glm::min(bricks[b] * brickSide + brickSide - 2, high);
      for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
          for (int x = first.x; x <= last.x; ++x) {
            const unsigned corners = cornersOf({x, y, z});
            if (corners == 0 || corners == 255) continue;
            const glm::dvec4 middle(glm::dvec3(x, y, z) + 0.5, 1.0);
            if (!keeps(kept, glm::dvec3(worldFromIndex * middle))) continue;
            const double steepness = glm::length(worldFromIndexGradient * gradientOf(corners));
            if (steepness > 0.0) perBrick[b].push_back({{x, y, z}, corners, steepness * grid.voxelVolume()});
          }
    }
  });
  std::vector<Element> elements;
  for (const std::vector<Element>& found : perBrick) elements.insert(elements.end(), found.begin(), found.end());
  return elements;
}

/// Normals out of the focus, averaged over the cells around. A single cell of a 0/1 indicator has few possible normals;
/// an average over about two voxels of the coarsest axis in every direction smooths the steps.
class Normals {
 public:
  Normals(const Grid& grid, const Corners& cornersOf)
      : cornersOf_(cornersOf),
        last_(grid.dims - 2),
        worldFromIndexGradient_(glm::transpose(glm::dmat3(grid.indexFromWorld()))) {
    const double coarsest = std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    for (int axis = 0; axis < 3; ++axis)
      radius_[axis] = std::clamp(static_cast<int>(std::lround(2.0 * coarsest / grid.spacing[axis])), 2, mostRadius);
  }

  glm::dvec3 operator()(const Element& element) const {
    const glm::dvec3 own = worldFromIndexGradient_ * gradientOf(element.corners);
    glm::dvec3 gradient(0.0);
    for (int z = -radius_.z; z <= radius_.z; ++z)
      for (int y = -radius_.y; y <= radius_.y; ++y)
        for (int x = -radius_.x; x <= radius_.x; ++x) {
          const glm::ivec3 neighbour = element.cell + glm::ivec3(x, y, z);
          if (glm::any(glm::lessThan(neighbour, glm::ivec3(0))) || glm::any(glm::greaterThan(neighbour, last_)))
            continue;
          const glm::dvec3 there = worldFromIndexGradient_ * gradientOf(cornersOf_(neighbour));
          // The far side of a thin structure is another surface.
          if (glm::dot(there, own) <= 0.0) continue;
          const glm::ivec3 near = radius_ + 1 - glm::abs(glm::ivec3(x, y, z));
          gradient += there * static_cast<double>(near.x * near.y * near.z);
        }
    return -glm::normalize(gradient);
  }

 private:
  static constexpr int mostRadius = 6;  ///< cells: beyond spacings of 1 : 3 it is no longer round

  const Corners& cornersOf_;
  glm::ivec3 last_, radius_{2};
  glm::dmat3 worldFromIndexGradient_;
};

/// `count` positions of a running sum, evenly apart; calls take(index) for each.
template <class T, class Weight, class Take>
void sampleEvenly(std::span<const T> items, double sum, std::size_t count, Weight&& weightOf, Take&& take) {
  const double share = sum / static_cast<double>(count);
  double next = 0.5 * share, running = 0.0;
  std::size_t taken = 0;
  for (const T& item : items)
    for (running += weightOf(item); next < running && taken < count; next += share, ++taken) take(item);
}

}  // namespace

FocusSurface sampleSurface(const Scene& scene, const FocusIndex& index, int count) {
  FocusSurface surface;
  if (!index.box || count <= 0) return surface;
  const Grid& grid = scene.volume->grid;
  const Corners cornersOf(scene, index);
  const std::vector<Element> elements = elementsOf(grid, index, cornersOf, halfSpaces(scene.look.clipping, grid));
  double greatest = 0.0;
  for (const Element& element : elements) greatest += element.greatestArea;

  // Areas need normals, which are expensive: only a sample of the elements, several times as many as wanted, gets them.
  struct Proposal {
    const Element* element = nullptr;
    glm::dvec3 normal{0.0};
    double area = 0.0;  ///< in shares
  };
  constexpr std::size_t proposalsPerPoint = 4;
  const auto wanted = static_cast<std::size_t>(count);
  std::vector<Proposal> proposals;
  sampleEvenly(
      std::span<const Element>(elements), greatest, proposalsPerPoint * wanted,
      [](const Element& element) { return element.greatestArea; },
      [&](const Element& element) { proposals.push_back({&element}); });
  const Normals normalOf(grid, cornersOf);
  const glm::dmat3 worldFromIndexGradient = glm::transpose(glm::dmat3(grid.indexFromWorld()));
  parallelFor(proposals.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Proposal& proposal = proposals[i];
      proposal.normal = normalOf(*proposal.element);
      const glm::dvec3 steepest = worldFromIndexGradient * gradientOf(proposal.element->corners);
      proposal.area = std::max(0.0, -glm::dot(proposal.normal, steepest) / glm::length(steepest));
    }
  });
  double shares = 0.0;
  for (const Proposal& proposal : proposals) shares += proposal.area;
  if (shares <= 0.0) return surface;
  surface.area = greatest * shares / static_cast<double>(proposals.size());
  sampleEvenly(
      std::span<const Proposal>(proposals), shares, wanted, [](const Proposal& proposal) { return proposal.area; },
      [&](const Proposal& proposal) {
        const auto [mean, gradient] = levelIn(*proposal.element, index.smoothed.get());
        const double steepness = std::max(glm::dot(gradient, gradient), 1e-12);
        const glm::dvec3 toLevel = gradient * ((0.5 - mean) / steepness);
        surface.points.push_back(
            {glm::dvec3(proposal.element->cell) + 0.5 + glm::clamp(toLevel, glm::dvec3(-0.5), glm::dvec3(0.5)),
             proposal.normal});
      });
  return surface;
}

}  // namespace fenestra::placement
