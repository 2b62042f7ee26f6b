#pragma once
// Measures the surface of labels, as it is and smoothed: its volume, its points and its normals.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rendering/scene/SmoothedIndicator.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests {

/// An indicator at the voxels of a small map, as it is or smoothed.
class SampledIndicator {
 public:
  template <class InsideAt>
  SampledIndicator(glm::ivec3 dims, InsideAt insideAt, LabelSmoothing strength) : box_(gridOf(dims)) {
    const auto labels = labelsOf(box_, [&](glm::ivec3 at) { return insideAt(at) ? 3 : at.x % 3; });
    values_.resize(box_.voxelCount());
    if (strength == LabelSmoothing::Off) {
      forEachVoxel(dims, [&](glm::ivec3 at) { values_[box_.offset(at)] = insideAt(at) ? 1.0 : 0.0; });
      return;
    }
    const std::array<std::uint16_t, 2> inFocus{3, 7};
    const SmoothedIndicator smoothed(*labels, inFocus, strength);
    forEachVoxel(dims, [&](glm::ivec3 at) { values_[box_.offset(at)] = smoothed.at(at) / 65535.0; });
  }

  glm::ivec3 dims() const { return box_.dims; }
  double at(glm::ivec3 voxel) const { return values_[box_.offset(glm::clamp(voxel, glm::ivec3(0), box_.dims - 1))]; }
  double at(glm::dvec3 index) const {
    const glm::ivec3 low(glm::floor(index));
    const glm::dvec3 w = index - glm::dvec3(low);
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
      sum +=
          at(low + corner) * (corner.x ? w.x : 1.0 - w.x) * (corner.y ? w.y : 1.0 - w.y) * (corner.z ? w.z : 1.0 - w.z);
    }
    return sum;
  }
  bool isCut(glm::ivec3 cell) const {
    int inside = 0;
    for (int i = 0; i < 8; ++i) inside += at(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2)) >= 0.5;
    return inside != 0 && inside != 8;
  }
  /// Voxels enclosed by the 0.5 level, from the grid's first voxel centres to its last: exact along the axis of the
  /// steepest change, by `lines` lines a cell's side across.
  double volume(int lines) const {
    double sum = 0.0;
    forEachVoxel(box_.dims - 1, [&](glm::ivec3 cell) {
      if (!isCut(cell)) {
        sum += at(cell) >= 0.5;
        return;
      }
      const glm::dvec3 slope = glm::abs(gradient(glm::dvec3(cell) + 0.5));
      const int axis = slope.z >= std::max(slope.x, slope.y) ? 2 : slope.y >= slope.x ? 1 : 0;
      for (int j = 0; j < lines; ++j)
        for (int i = 0; i < lines; ++i) {
          glm::dvec3 start(cell);
          start[(axis + 1) % 3] += (i + 0.5) / lines;
          start[(axis + 2) % 3] += (j + 0.5) / lines;
          glm::dvec3 end = start;
          end[axis] += 1.0 - 1e-12;  // beyond lies another cell
          const double low = at(start) - 0.5, high = at(end) - 0.5;
          const double share =
              (low >= 0.0) == (high >= 0.0) ? (low >= 0.0 ? 1.0 : 0.0) : std::max(low, high) / std::abs(high - low);
          sum += share / (lines * lines);
        }
    });
    return sum;
  }
  /// Points of the level: crossings with lines along each axis, `lines` a cell's side, those between voxels included.
  std::vector<glm::dvec3> points(int lines) const {
    std::vector<glm::dvec3> found;
    forEachVoxel(box_.dims - 1, [&](glm::ivec3 cell) {
      if (!isCut(cell)) return;
      for (int axis = 0; axis < 3; ++axis)
        for (int j = 0; j < lines; ++j)
          for (int i = 0; i < lines; ++i) {
            glm::dvec3 start(cell), end;
            start[(axis + 1) % 3] += static_cast<double>(i) / lines;
            start[(axis + 2) % 3] += static_cast<double>(j) / lines;
            end = start;
            end[axis] += 1.0 - 1e-12;
            const double low = at(start) - 0.5, high = at(end) - 0.5;
            if ((low >= 0.0) != (high >= 0.0)) found.push_back(start + (end - start) * (low / (low - high)));
          }
    });
    return found;
  }
  glm::dvec3 gradient(glm::dvec3 index) const {
    constexpr double step = 1e-4;
    glm::dvec3 result;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 offset(0.0);
      offset[axis] = step;
      result[axis] = (at(index + offset) - at(index - offset)) / (2.0 * step);
    }
    return result;
  }

 private:
  Grid box_;
  std::vector<double> values_;
};

}  // namespace fenestra::tests
