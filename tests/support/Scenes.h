#pragma once
// Small volumes, label maps and scenes that tests make for themselves.

#include <limits>
#include <memory>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "rendering/scene/Scene.h"

namespace fenestra::tests {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline Grid gridOf(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1.0), glm::dvec3 origin = glm::dvec3(0.0)) {
  Grid grid;
  grid.dims = dims;
  grid.spacing = spacing;
  grid.origin = origin;
  return grid;
}

/// A grid whose axes follow no patient axis.
inline Grid obliqueGrid(glm::ivec3 dims) {
  Grid grid = gridOf(dims, {0.7, 1.3, 2.1}, {-12.0, 30.0, 5.0});
  grid.direction = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5))));
  return grid;
}

template <class F>
void forEachVoxel(glm::ivec3 dims, F&& f) {
  glm::ivec3 index;
  for (index.z = 0; index.z < dims.z; ++index.z)
    for (index.y = 0; index.y < dims.y; ++index.y)
      for (index.x = 0; index.x < dims.x; ++index.x) f(index);
}

/// T voxels valueAt(index).
template <class T = double, class F>
std::shared_ptr<Volume> volumeOf(const Grid& grid, F&& valueAt) {
  auto volume = std::make_shared<Volume>();
  volume->grid = grid;
  volume->voxels = Voxels(scalarTypeOf<T>(), grid.voxelCount());
  forEachVoxel(grid.dims,
               [&](glm::ivec3 index) { volume->voxels.as<T>()[grid.offset(index)] = static_cast<T>(valueAt(index)); });
  volume->computeRange();
  return volume;
}

template <class F>
std::shared_ptr<LabelMap> labelsOf(const Grid& grid, F&& labelAt) {
  auto labels = std::make_shared<LabelMap>();
  labels->grid = grid;
  labels->voxels = Voxels(ScalarType::UInt16, grid.voxelCount());
  forEachVoxel(grid.dims, [&](glm::ivec3 index) {
    labels->voxels.as<std::uint16_t>()[grid.offset(index)] = static_cast<std::uint16_t>(labelAt(index));
  });
  return labels;
}

/// A table of single voxels.
template <class F>
std::shared_ptr<const CoarseMask> tableWhere(const Grid& grid, F&& isTable) {
  auto table = std::make_shared<CoarseMask>();
  table->dims = grid.dims;
  forEachVoxel(grid.dims, [&](glm::ivec3 index) {
    table->cells.push_back(isTable(index));
    table->count += table->cells.back();
  });
  return table;
}

/// Transparent below `value`, opaque above.
inline TransferFunction opaqueFrom(double value) {
  return {{{value, {glm::dvec3(1.0), 0.0}}, {value, {glm::dvec3(1.0), 5.0}}}};
}

/// Labels over a volume of zeros with a transparent context: nothing but the focus is met.
template <class F>
Scene labelScene(const Grid& grid, F&& labelAt) {
  Scene scene;
  scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3) { return 0; });
  scene.labels = labelsOf(grid, labelAt);
  scene.look.focus = LabelFocus{{1}};
  return scene;
}

/// A focus of values in [low, high] without a smallest component, in a transparent context.
template <class F>
Scene valueScene(const Grid& grid, F&& valueAt, double low, double high = infinity) {
  Scene scene;
  scene.volume = volumeOf(grid, valueAt);
  scene.look.focus = ValueFocus{{low, high}, 0.0};
  return scene;
}

/// A camera at `eye` that looks at `target`.
inline Camera lookAt(glm::dvec3 eye, glm::dvec3 target, Projection projection = Projection::Perspective,
                     double orthographicHeight = 10.0) {
  Camera camera;
  camera.projection = projection;
  camera.eye = eye;
  camera.target = target;
  camera.orthographicHeight = orthographicHeight;
  return camera;
}

inline glm::dvec3 randomUnit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  glm::dvec3 v;
  do v = {normal(random), normal(random), normal(random)};
  while (glm::length(v) < 1e-3);
  return glm::normalize(v);
}

inline glm::dvec3 randomIn(std::mt19937& random, glm::dvec3 low, glm::dvec3 high) {
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  return {in(low.x, high.x), in(low.y, high.y), in(low.z, high.z)};
}

}  // namespace fenestra::tests
