#pragma once
// The lighting model that the renderer and its reference share.
//
// At every voxel, the world-space gradient by central differences of the stored values (one-sided at the volume's
// border) gives a unit normal n and a gate g = smoothstep(gradientGateLow, gradientGateHigh, |gradient| · finest
// spacing / value range): below the first a gradient is noise. Between voxels the vectors g·n are interpolated
// trilinearly to V. For a spline, the gradient is its own at the voxels' centres, and V the B-spline of the vectors g·n
// (SplineVectors): normals at every point of the spline would turn too fast where the gradient vanishes. Lighting by
// V's direction fades in with its length: certainty = smoothstep(0, certainLength, |V|), over the light that a surface
// of average orientation gets. A label focus has the smoothed indicator's normal instead (see GpuScene::focusSmooth),
// with certainty 1. Light is Blinn-Phong from one distant source, both sides of a surface lit.

#include <span>
#include <string_view>

#include "rendering/settings/Camera.h"
#include "rendering/settings/Look.h"

namespace fenestra {

/// Towards the light, unit, world; fixed to the camera.
glm::dvec3 lightDirection(const Camera::Axes& axes, const Shading& shading);

/// Ready-made light: how much of it surfaces give back in which way, not where it comes from.
struct LightPreset {
  std::string_view id, name, description;
  double ambient, diffuse, specular, shininess;

  /// Leaves the rest as it is, but switches shading on.
  void applyTo(Shading& shading) const;
};
/// standard, a scene's default; matte; bone; wet; technical.
std::span<const LightPreset> lightPresets();

namespace lighting {

/// On CT (range about 4000 HU, 1 mm) these are 8 and 40 HU/mm.
inline constexpr double gradientGateLow = 0.002, gradientGateHigh = 0.01;
inline constexpr double certainLength = 0.5;
/// |n·l| of a surface of average orientation.
inline constexpr double meanIncidence = 0.7;
/// A cut face is lit by its own normal: this share of it at the face, falling to 1/e over wallDepthVoxels of the finest
/// spacing; the rest keeps the strata's edges.
inline constexpr double wallShare = 0.75, wallDepthVoxels = 2.0;

}  // namespace lighting
}  // namespace fenestra
