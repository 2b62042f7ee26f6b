#include "rendering/reference/Light.h"

#include "rendering/scene/Lighting.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

/// A gradient is covariant: world from index by the inverse transpose of the lattice's matrix.
glm::dmat3 worldFromIndexGradient(const Grid& grid) { return glm::transpose(glm::dmat3(grid.indexFromWorld())); }

}  // namespace

double smoothstep(double low, double high, double x) {
  const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

Light::Light(const Camera& camera, const Shading& how) : direction(lightDirection(camera.axes(), how)), shading(how) {}

double Light::intensity(glm::dvec3 normal, glm::dvec3 rayDirection) const {
  const double average = shading.diffuse * lighting::meanIncidence, length = glm::length(normal);
  const double certainty = smoothstep(0.0, lighting::certainLength, length);
  if (certainty == 0.0) return std::min(average, 1.0);
  const glm::dvec3 unit = normal / length, half = glm::normalize(direction - rayDirection);
  const double lit = shading.diffuse * std::abs(glm::dot(unit, direction)) +
                     shading.specular * std::pow(std::abs(glm::dot(unit, half)), shading.shininess);
  return std::min(glm::mix(average, lit, certainty), 1.0);
}

glm::dvec3 Light::lit(glm::dvec3 colour, glm::dvec3 normal, glm::dvec3 rayDirection, glm::dvec2 open) const {
  const glm::dvec3 half = glm::normalize(direction - rayDirection);
  return colour * incident(std::abs(glm::dot(normal, direction)), open) +
         open.y * shading.specular * std::pow(std::abs(glm::dot(normal, half)), shading.shininess);
}

glm::dvec3 Light::shade(glm::dvec3 colour, glm::dvec3 normal, glm::dvec3 rayDirection, glm::dvec2 open) const {
  const glm::dvec3 average = colour * incident(lighting::meanIncidence, open);
  const double length = glm::length(normal), certainty = smoothstep(0.0, lighting::certainLength, length);
  if (certainty == 0.0) return average;
  return glm::mix(average, lit(colour, normal / length, rayDirection, open), certainty);
}

VoxelNormals::VoxelNormals(const Volume& volume)
    : dims_(volume.grid.dims), worldFromIndexGradient_(worldFromIndexGradient(volume.grid)) {
  const glm::dvec3 spacing = volume.grid.spacing;
  gateUnit_ = (volume.range.high - volume.range.low) / std::min({spacing.x, spacing.y, spacing.z});
}

glm::dvec3 VoxelNormals::gated(glm::dvec3 indexGradient) const {
  const glm::dvec3 gradient = world(indexGradient);
  const double length = glm::length(gradient);
  if (!(length > 0.0)) return glm::dvec3(0.0);
  return gradient * (smoothstep(lighting::gradientGateLow, lighting::gradientGateHigh, length / gateUnit_) / length);
}

FocusNormals::FocusNormals(const Grid& grid, const FocusField& focus)
    : worldFromIndexGradient_(worldFromIndexGradient(grid)) {
  glm::ivec3 low = grid.dims, high(-1), index;
  for (index.z = 0; index.z < grid.dims.z; ++index.z)
    for (index.y = 0; index.y < grid.dims.y; ++index.y)
      for (index.x = 0; index.x < grid.dims.x; ++index.x)
        if (focus.isLabelled(index)) {
          low = glm::min(low, index);
          high = glm::max(high, index);
        }
  if (high.x < 0) return;
  // Two passes of five taps reach four voxels out; queries lie within two voxels of the labels, where a smoothed
  // indicator is not 0 yet.
  constexpr int margin = 7;
  low_ = low - margin;
  box_.dims = high - low + 1 + 2 * margin;
  field_.resize(box_.voxelCount());
  for (index.z = 0; index.z < box_.dims.z; ++index.z)
    for (index.y = 0; index.y < box_.dims.y; ++index.y)
      for (index.x = 0; index.x < box_.dims.x; ++index.x)
        field_[box_.offset(index)] = static_cast<float>(focus.indicatorAtVoxel(low_ + index));

  // Filters a 0/1 indicator, so that values are whole numbers over at most 2^24: exact in single precision.
  const auto filter = [&](int axis) {
    const int across = (axis + 1) % 3, along = (axis + 2) % 3;
    parallelFor(static_cast<std::size_t>(box_.dims[along]), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<float> line(static_cast<std::size_t>(box_.dims[axis]));
      glm::ivec3 at;
      for (at[along] = static_cast<int>(begin); at[along] < static_cast<int>(end); ++at[along])
        for (at[across] = 0; at[across] < box_.dims[across]; ++at[across]) {
          const auto original = [&](int i) {
            glm::ivec3 from = at;
            from[axis] = std::clamp(i, 0, box_.dims[axis] - 1);
            return field_[box_.offset(from)];
          };
          for (int i = 0; i < box_.dims[axis]; ++i)
            line[static_cast<std::size_t>(i)] = (original(i - 2) + 4.0f * original(i - 1) + 6.0f * original(i) +
                                                 4.0f * original(i + 1) + original(i + 2)) /
                                                16.0f;
          for (at[axis] = 0; at[axis] < box_.dims[axis]; ++at[axis])
            field_[box_.offset(at)] = line[static_cast<std::size_t>(at[axis])];
        }
    });
  };
  for (int pass = 0; pass < 2; ++pass)
    for (int axis = 0; axis < 3; ++axis) filter(axis);
}

double FocusNormals::smoothed(glm::dvec3 index) const {
  const glm::dvec3 local = index - glm::dvec3(low_);
  const glm::ivec3 cell(glm::floor(local));
  const Corners corners = cornersOf(cell, box_.dims, [&](glm::ivec3 at) { return double{field_[box_.offset(at)]}; });
  return interpolate(corners, local - glm::dvec3(cell));
}

glm::dvec3 FocusNormals::at(glm::dvec3 index) const {
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = 1.0;
    gradient[axis] = smoothed(index + step) - smoothed(index - step);
  }
  return worldFromIndexGradient_ * gradient;
}

}  // namespace fenestra::reference
