#pragma once
// A surface as VTK holds one.

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "io/surface/Triangles.h"

namespace fenestra::io {

/// Points in double precision, in the surface's order.
inline vtkSmartPointer<vtkPolyData> meshOf(const Surface& surface) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(surface.points.size()));
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), &surface.points[i].x);
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : surface.triangles) {
    const vtkIdType corners[3] = {triangle[0], triangle[1], triangle[2]};
    cells->InsertNextCell(3, corners);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

}  // namespace fenestra::io
