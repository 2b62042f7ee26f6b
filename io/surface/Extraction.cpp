#include "io/surface/SurfacePart.h"

#include <algorithm>
#include <cmath>

#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "io/base/Memory.h"
#include "io/surface/Mesh.h"
#include "rendering/scene/FocusCells.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// A field that is positive inside the focus, on a box of voxels that holds it with a border of one voxel around. The
/// border mirrors the sign of its neighbours where it lies beyond the volume, so that the surface closes on the faces
/// of the outermost voxels.
struct Field {
  glm::ivec3 low{0}, dims{0};  ///< first voxel and size of the box; low may be -1
  std::vector<float> values;   ///< x fastest
  double volume = 0.0;         ///< mm³ that the surface has to enclose; 0: what the level set encloses
};

/// Calls inside(index, value) for voxels, where value > 0 is inside; NaN never comes.
using ValueAt = std::function<double(glm::ivec3)>;

Field fieldOf(const Grid& grid, const ValueAt& valueAt, const fs::path& source) {
  glm::ivec3 low = grid.dims, high(-1);
  std::uint64_t inside = 0;
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        if (!(valueAt({x, y, z}) > 0.0)) continue;
        low = glm::min(low, glm::ivec3(x, y, z));
        high = glm::max(high, glm::ivec3(x, y, z));
        ++inside;
      }
  if (inside == 0) throw Error(source, "has no voxel in the focus", "choose other labels or another range of values");
  Field field;
  field.low = low - 1;
  field.dims = high - low + 3;
  field.volume = static_cast<double>(inside) * grid.voxelVolume();
  Grid box;
  box.dims = field.dims;
  checkMemory(source, saturatingProduct(box.voxelCount(), sizeof(float)));
  field.values.resize(box.voxelCount());
  for (int z = 0; z < box.dims.z; ++z)
    for (int y = 0; y < box.dims.y; ++y)
      for (int x = 0; x < box.dims.x; ++x) {
        const glm::ivec3 index = field.low + glm::ivec3(x, y, z);
        const double value = valueAt(glm::clamp(index, glm::ivec3(0), grid.dims - 1));
        field.values[box.offset({x, y, z})] = static_cast<float>(grid.contains(index) ? value : -std::abs(value));
      }
  return field;
}

Field labelField(const LabelMap& labels, const LabelFocus& focus, const fs::path& source) {
  std::vector<bool> wanted(65536, false);
  for (const std::uint16_t label : focus.labels) wanted[label] = true;
  return labels.voxels.visit([&](auto voxels) {
    return fieldOf(
        labels.grid,
        [&, voxels](glm::ivec3 index) {
          return wanted[static_cast<std::uint16_t>(voxels[labels.grid.offset(index)])] ? 0.5 : -0.5;
        },
        source);
  });
}

Field valueField(const ShownVolume& shown, const ValueFocus& focus, const fs::path& source) {
  const FocusCells cells = focusCells(shown, focus);
  return withValues(shown, [&](auto valueAt) {
    Field field = fieldOf(
        shown.volume->grid,
        [&](glm::ivec3 index) {
          const double value = valueAt(index);
          const double inside = std::min(value - focus.values.low, focus.values.high - value);
          return cells.contains(index) ? inside : -std::abs(inside);
        },
        source);
    field.volume = 0.0;
    return field;
  });
}

/// The triangles of the level set, in voxel indices.
Surface levelSet(const Field& field) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(field.dims.x, field.dims.y, field.dims.z);
  vtkNew<vtkFloatArray> scalars;
  // VTK reads the array only; 1: it stays ours.
  scalars->SetArray(const_cast<float*>(field.values.data()), static_cast<vtkIdType>(field.values.size()), 1);
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* found = edges->GetOutput();
  Surface surface;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i) {
    double at[3];
    found->GetPoint(i, at);
    surface.points.push_back(glm::dvec3(at[0], at[1], at[2]) + glm::dvec3(field.low));
  }
  const auto cells = vtk::TakeSmartPointer(found->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(count, corners);
    if (count == 3)
      surface.triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                                   static_cast<std::uint32_t>(corners[2])});
  }
  return surface;
}

/// Removes the steps of the voxels; points keep their order. World mm.
std::vector<glm::dvec3> smoothed(const Surface& surface) {
  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  filter->SetInputData(meshOf(surface));
  // A pass band of 0.1 removes what is shorter than about six edges: the steps, not the shape.
  filter->SetPassBand(0.1);
  filter->SetNumberOfIterations(20);
  filter->NormalizeCoordinatesOn();
  filter->NonManifoldSmoothingOn();
  filter->FeatureEdgeSmoothingOff();
  filter->BoundarySmoothingOff();
  filter->Update();
  std::vector<glm::dvec3> result(surface.points.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    filter->GetOutput()->GetPoint(static_cast<vtkIdType>(i), &result[i].x);
  return result;
}

/// Unit normals of the points, weighted by area, and the whole area.
std::vector<glm::dvec3> normalsOf(const Surface& surface, double& area) {
  std::vector<glm::dvec3> normals(surface.points.size(), glm::dvec3(0.0));
  area = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    const glm::dvec3 weighted =
        0.5 * glm::cross(surface.points[b] - surface.points[a], surface.points[c] - surface.points[a]);
    area += glm::length(weighted);
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += weighted;
  }
  for (glm::dvec3& normal : normals)
    if (const double length = glm::length(normal); length > 0.0) normal /= length;
  return normals;
}

/// Moves all points along their normals until the surface encloses `volume`, and back to half a voxel from where the
/// level set has them.
void keepVolume(Surface& surface, const std::vector<glm::dvec3>& levelIndices, const Grid& grid, double volume) {
  const glm::dmat3 indexFromWorld(grid.indexFromWorld()), worldFromIndex(grid.worldFromIndex());
  const auto hold = [&] {
    // A thousandth less than half a voxel, for the rounding of single precision.
    constexpr double reach = 0.499;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
      const glm::dvec3 level = worldFromIndex * levelIndices[i] + grid.origin;
      const glm::dvec3 moved = indexFromWorld * (surface.points[i] - level);
      if (const double distance = glm::length(moved); distance > reach)
        surface.points[i] = level + worldFromIndex * (moved * (reach / distance));
    }
  };
  hold();
  constexpr int rounds = 30;
  for (int round = 0; round < rounds; ++round) {
    const double missing = volume - surface.volume();
    if (std::abs(missing) < 1e-5 * volume) return;
    double area = 0.0;
    const std::vector<glm::dvec3> normals = normalsOf(surface, area);
    if (!(area > 0.0)) return;
    for (std::size_t i = 0; i < surface.points.size(); ++i) surface.points[i] += missing / area * normals[i];
    hold();
  }
}

}  // namespace

Surface extractWithVtk(const Scene& scene, const fs::path& source, const SurfaceOptions& options,
                       const Progress& progress) {
  const auto report = [&](double fraction, std::string_view doing) {
    if (progress && !progress(fraction, doing)) throw Cancelled();
  };
  report(0.0, "finding the focus");
  Field field;
  const auto* labels = std::get_if<LabelFocus>(&scene.look.focus);
  const auto* values = std::get_if<ValueFocus>(&scene.look.focus);
  if (labels && scene.labels)
    field = labelField(*scene.labels, *labels, source);
  else if (values && scene.volume)
    field = valueField(shownVolume(scene), *values, source);
  else
    throw Error(source, "has no focus to take a surface of", "choose labels or a range of values as the focus");

  report(0.3, "extracting the surface");
  const Grid& grid = labels ? scene.labels->grid : scene.volume->grid;
  Surface surface = levelSet(field);
  field.values = {};
  const std::vector<glm::dvec3> levelIndices = surface.points;
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  for (glm::dvec3& point : surface.points) point = glm::dvec3(worldFromIndex * glm::dvec4(point, 1.0));
  // Mirrored grids turn triangles over.
  if (surface.volume() < 0.0)
    for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  if (!options.smooth) return surface;

  report(0.6, "smoothing the surface");
  const double volume = field.volume > 0.0 ? field.volume : surface.volume();
  surface.points = smoothed(surface);
  report(0.8, "smoothing the surface");
  keepVolume(surface, levelIndices, grid, volume);
  return surface;
}

}  // namespace fenestra::io
