#include "rendering/placement/FocusSurface.h"

#include <bit>
#include <cmath>
#include <cstdlib>

namespace fenestra::placement {
namespace {

struct Element {
  glm::ivec3 cell;
  FocusSurface::Point point;
  double area;
};

/// Bit i: corner i (x fastest) of an interior cell (index space) is in the focus.
unsigned cornersOf(const Scene& scene, const FocusIndex& index, glm::ivec3 cell) {
  const glm::ivec3 framed = cell + 1;
  const std::uint32_t slot = index.slots[brickOffset(index.bricks, framed / brickSide)];
  if (slot == 0) return 0;
  const std::size_t local = static_cast<std::size_t>((framed.x & 7) + 8 * ((framed.y & 7) + 8 * (framed.z & 7)));
  if (index.kind == FocusIndex::Kind::Labels) {
    if (slot == 1) return 255;
    const std::size_t byte = (slot - 2) * std::size_t{512} + local;
    return (index.cells[byte / 4] >> (8 * (byte % 4))) & 255u;
  }
  if (slot >= 2) {
    const std::size_t bit = (slot - 2) * std::size_t{512} + local;
    if (((index.cells[bit / 32] >> (bit % 32)) & 1u) == 0) return 0;
  }
  const ValueRange range = std::get<ValueFocus>(scene.focus).values;
  unsigned corners = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 voxel = glm::min(cell + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2), scene.volume->grid.dims - 1);
    const double value = scene.volume->value(voxel);
    if (value >= range.low && value <= range.high) corners |= 1u << i;
  }
  return corners;
}

/// Of the trilinear indicator at a cell's centre, per index step.
glm::dvec3 gradientOf(unsigned corners) {
  glm::dvec3 gradient(0.0);
  for (int i = 0; i < 8; ++i)
    if (corners >> i & 1u)
      gradient += glm::dvec3((i & 1) ? 0.25 : -0.25, (i & 2) ? 0.25 : -0.25, (i & 4) ? 0.25 : -0.25);
  return gradient;
}

Element elementOf(const Grid& grid, const glm::dmat3& worldFromIndexGradient, glm::ivec3 cell, unsigned corners) {
  const glm::dvec3 gradient = gradientOf(corners);
  const glm::dvec3 world = worldFromIndexGradient * gradient;
  const double steepness = glm::length(world), square = glm::dot(gradient, gradient);
  Element element{cell, {glm::dvec3(cell) + 0.5, glm::dvec3(0.0)}, steepness * grid.voxelVolume()};
  if (square > 0.0) {
    const double mean = 0.125 * std::popcount(corners);
    element.point.index += glm::clamp(gradient * ((0.5 - mean) / square), glm::dvec3(-0.5), glm::dvec3(0.5));
    element.point.normal = -world / steepness;
  }
  return element;
}

/// The normal over the neighbouring cells, weighted 1 2 1 along each axis. One cell of a 0/1 indicator knows a few
/// normals only, most of them exactly edge-on to the patient's axes.
glm::dvec3 smoothNormal(const Scene& scene, const FocusIndex& index, const glm::dmat3& worldFromIndexGradient,
                        const Element& element) {
  const glm::ivec3 last = scene.volume->grid.dims - 2;
  glm::dvec3 gradient(0.0);
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const glm::ivec3 neighbour = glm::clamp(element.cell + glm::ivec3(x, y, z), glm::ivec3(0), last);
        const double weight = (2 - std::abs(x)) * (2 - std::abs(y)) * (2 - std::abs(z));
        gradient += weight * gradientOf(cornersOf(scene, index, neighbour));
      }
  const glm::dvec3 world = worldFromIndexGradient * gradient;
  const double steepness = glm::length(world);
  return steepness > 0.0 ? -world / steepness : element.point.normal;
}

}  // namespace

FocusSurface sampleSurface(const Scene& scene, const FocusIndex& index, int count) {
  FocusSurface surface;
  if (!index.box) return surface;
  const Grid& grid = scene.volume->grid;
  const glm::dmat3 worldFromIndexGradient = glm::transpose(glm::dmat3(grid.indexFromWorld()));
  const glm::ivec3 low = glm::max(index.box->low - 1, 0), high = glm::min(index.box->high, grid.dims - 2);
  std::vector<Element> elements;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const glm::ivec3 cell(x, y, z);
        const unsigned corners = cornersOf(scene, index, cell);
        if (corners == 0 || corners == 255) continue;
        const Element element = elementOf(grid, worldFromIndexGradient, cell, corners);
        if (element.area <= 0.0) continue;
        elements.push_back(element);
        surface.area += element.area;
      }
  // Systematic sampling along the running area: every point stands for the same share.
  const double share = surface.area / count;
  double next = 0.5 * share, running = 0.0;
  for (const Element& element : elements) {
    running += element.area;
    for (; next < running && surface.points.size() < static_cast<std::size_t>(count); next += share)
      surface.points.push_back({element.point.index, smoothNormal(scene, index, worldFromIndexGradient, element)});
  }
  return surface;
}

}  // namespace fenestra::placement
