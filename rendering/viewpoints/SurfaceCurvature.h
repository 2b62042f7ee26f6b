#pragma once
// How curved a surface is at points of it.

#include <vector>

#include <glm/glm.hpp>

namespace fenestra::placement {

/// Gaussian curvature in 1/mm² at each point of a surface (world, mm) with unit normals: the determinant of the shape
/// operator S, the symmetric 2×2 matrix for which S·Δx best fits Δn in the tangent plane, by least squares over the 12
/// nearest points on the same side of the surface (that is, whose normals are less than 90° from the point's own). On a
/// sphere of radius r it is 1/r² exactly, up to rounding. NaN where the points do not determine S.
std::vector<double> gaussianCurvatures(const std::vector<glm::dvec3>& positions,
                                       const std::vector<glm::dvec3>& normals);

/// Class of a Gaussian curvature K on a surface of area A (mm²): asinh(K · A / 4π) rounded to multiples of ½, so that a
/// sphere of any size is of one class and each class spans a factor of 1.65 of large curvatures of one sign.
int curvatureClass(double curvature, double area);

}  // namespace fenestra::placement
