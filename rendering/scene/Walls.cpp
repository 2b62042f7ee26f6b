#include "rendering/scene/Walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "rendering/scene/Scene.h"
#include "rendering/volume/Outline.h"

namespace fenestra {
namespace {

/// Colour of the lines where other slices cut a wall.
constexpr glm::dvec3 crossingColour(0.95, 0.85, 0.35);

constexpr std::array planes{SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal};

int axisOf(SlicePlane plane, const Grid& grid) {
  const glm::ivec3 axes = grid.patientAxes();
  return plane == SlicePlane::Axial ? axes.z : plane == SlicePlane::Sagittal ? axes.x : axes.y;
}

bool isOn(SlicePlane plane, const MethodStages::Walls& walls) {
  return plane == SlicePlane::Axial ? walls.axial : plane == SlicePlane::Sagittal ? walls.sagittal : walls.coronal;
}

/// Voxel index, within the volume.
glm::dvec3 crosshairIndex(const Grid& grid, const ShownSlices& slices) {
  const glm::dvec3 world = slices.crosshair.value_or(grid.centre());
  const glm::dvec3 index = glm::dmat3(grid.indexFromWorld()) * (world - grid.origin);
  return glm::clamp(index, glm::dvec3(0.0), glm::dvec3(grid.dims - 1));
}

/// How far, along a wall's normal, it stands away from its voxels.
glm::dvec3 shiftAround(const Wall& wall, const Grid& grid, const Camera& camera) {
  const glm::dvec3 centre = grid.centre();
  glm::dvec3 away = glm::normalize(glm::cross(wall.right, wall.down));
  const glm::dvec3 sight = camera.projection == Projection::Perspective ? centre - camera.eye : camera.axes().forward;
  if (glm::dot(away, sight) < 0.0) away = -away;
  double farthest = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& corner : grid.corners()) farthest = std::max(farthest, glm::dot(away, corner - wall.origin));
  return away * (farthest + wallMargin * grid.boundingRadius());
}

/// The least box of places that holds a label.
struct Extent {
  glm::ivec2 low, high;
};

/// The outlines of each label that a wall's voxels have and `shows` lets through, by label.
template <class Shows>
void addOutlines(const Wall& wall, const LabelMap& map, const Shows& shows, std::vector<WallLine>& lines) {
  std::vector<std::uint16_t> labels(static_cast<std::size_t>(wall.size.x) * static_cast<std::size_t>(wall.size.y));
  std::map<std::uint16_t, Extent> extents;
  map.voxels.visit([&](auto scalars) {
    std::size_t at = 0;
    for (int v = 0; v < wall.size.y; ++v)
      for (int u = 0; u < wall.size.x; ++u, ++at) {
        const glm::ivec3 index(wall.indexFromPlace({u, v}));
        labels[at] = static_cast<std::uint16_t>(scalars[map.grid.offset(index)]);
        if (labels[at] == 0) continue;
        Extent& extent = extents.try_emplace(labels[at], Extent{{u, v}, {u, v}}).first->second;
        extent = {glm::min(extent.low, glm::ivec2(u, v)), glm::max(extent.high, glm::ivec2(u, v))};
      }
  });
  for (const auto& [label, extent] : extents) {
    const std::optional<glm::dvec3> colour = shows(label);
    if (!colour) continue;
    const glm::ivec2 size = extent.high - extent.low + 1;
    std::vector<char> inside;
    inside.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int v = extent.low.y; v <= extent.high.y; ++v)
      for (int u = extent.low.x; u <= extent.high.x; ++u)
        inside.push_back(
            labels[static_cast<std::size_t>(v) * static_cast<std::size_t>(wall.size.x) + static_cast<std::size_t>(u)] ==
            label);
    WallLine& line = lines.emplace_back(WallLine{*colour, {}});
    for (const std::vector<glm::dvec2>& loop : smoothOutlines(inside, size.x, size.y))
      for (std::size_t i = 0; i < loop.size(); ++i)
        line.pieces.push_back({loop[i] + glm::dvec2(extent.low), loop[(i + 1) % loop.size()] + glm::dvec2(extent.low)});
  }
}

glm::dvec3 colourIn(const LabelMap& map, std::uint16_t label) {
  const Label* known = map.find(label);
  return known ? known->colour : defaultLabelColour(label);
}

}  // namespace

std::optional<MethodStages::Walls> wallsOf(const Look& look) {
  return look.cutaway.enabled ? stagesOf(look.method).walls : std::nullopt;
}

bool dependsOnSlices(const Look& look) {
  if (wallsOf(look)) return true;
  const MethodStages stages = stagesOf(look.method);
  return look.cutaway.enabled && stages.lens && stages.lens->place == LensPlace::OverCrosshair;
}

glm::dvec3 Wall::indexFromPlace(glm::dvec2 place) const {
  glm::dvec3 index(slice);
  index[sides.x] = place.x;
  index[sides.y] = place.y;
  return index;
}

glm::dmat2 Wall::mmFromPlace() const {
  const double across = glm::length(right), along = glm::dot(right, down) / across;
  return {{across, 0.0}, {along, std::sqrt(std::max(glm::dot(down, down) - along * along, 0.0))}};
}

std::vector<Wall> wallsAt(const MethodStages::Walls& walls, const Grid& grid, const ShownSlices& slices,
                          const Camera& camera) {
  const glm::dvec3 crosshair = crosshairIndex(grid, slices);
  std::vector<Wall> found;
  for (const SlicePlane plane : planes) {
    if (!isOn(plane, walls)) continue;
    Wall wall;
    wall.plane = plane;
    wall.axis = axisOf(plane, grid);
    wall.slice = static_cast<int>(std::lround(crosshair[wall.axis]));
    wall.sides = {wall.axis == 0 ? 1 : 0, wall.axis == 2 ? 1 : 2};
    wall.size = {grid.dims[wall.sides.x], grid.dims[wall.sides.y]};
    wall.right = grid.direction[wall.sides.x] * grid.spacing[wall.sides.x];
    wall.down = grid.direction[wall.sides.y] * grid.spacing[wall.sides.y];
    wall.origin = grid.origin + grid.direction[wall.axis] * (grid.spacing[wall.axis] * wall.slice);
    if (walls.placement == WallPlacement::Around) wall.shift = shiftAround(wall, grid, camera);
    wall.origin += wall.shift;
    found.push_back(wall);
  }
  return found;
}

glm::dvec2 crossingOn(const Wall& wall, const Grid& grid, const ShownSlices& slices) {
  const glm::dvec3 crosshair = glm::round(crosshairIndex(grid, slices));
  return {crosshair[wall.sides.x], crosshair[wall.sides.y]};
}

double lineWidth(const Wall& wall, const Grid& grid) {
  const glm::dvec3 sides = glm::dvec3(grid.dims) * grid.spacing;
  const double finer = std::min(glm::length(wall.right), glm::length(wall.down));
  return std::clamp(std::max({sides.x, sides.y, sides.z}) / 250.0, 0.5 * finer, 3.0 * finer);
}

std::vector<WallLine> linesOn(const Wall& wall, const MethodStages::Walls& walls, const Scene& scene,
                              const ShownSlices& slices) {
  std::vector<WallLine> lines;
  if (walls.placement == WallPlacement::Around) {
    const glm::dvec2 at = crossingOn(wall, scene.volume->grid, slices);
    const glm::dvec2 low(-0.5), high = glm::dvec2(wall.size) - 0.5;
    lines.push_back({crossingColour, {{{at.x, low.y}, {at.x, high.y}}, {{low.x, at.y}, {high.x, at.y}}}});
  }
  if (!walls.outlines) return lines;
  const auto& structures = structuresOf(scene);
  if (structures)
    addOutlines(
        wall, *structures,
        [&](std::uint16_t label) -> std::optional<glm::dvec3> {
          const LabelSetting setting = settingFor(scene.look.labels, label);
          if (!setting.visible || !(setting.opacity > 0.0)) return {};
          return setting.colour.value_or(colourIn(*structures, label));
        },
        lines);
  if (scene.labels && scene.labels != structures)
    addOutlines(
        wall, *scene.labels, [&](std::uint16_t label) { return std::optional(colourIn(*scene.labels, label)); }, lines);
  return lines;
}

}  // namespace fenestra
