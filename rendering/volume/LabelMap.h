#pragma once
// A label map on the volume's grid, and the names of its labels.

#include <cstdint>
#include <string>
#include <vector>

#include "rendering/volume/Grid.h"
#include "rendering/volume/Voxels.h"

namespace fenestra {

struct Label {
  std::uint16_t value = 0;
  std::string name;
  glm::dvec3 colour{0.8};  ///< display RGB, 0..1
  bool operator==(const Label&) const = default;
};

/// Immutable once built; voxels are UInt8 or UInt16, 0 is background. `labels` lists every non-zero value present (and
/// may list absent ones that the file names), sorted by value.
struct LabelMap {
  Grid grid;
  Voxels voxels;
  std::vector<Label> labels;

  std::uint16_t value(glm::ivec3 index) const;
  const Label* find(std::uint16_t value) const;
};

/// Which values some voxel has: an element for each of the 65536 that there may be. Reads the whole map, on all cores.
std::vector<bool> labelsWithVoxels(const LabelMap& map);

/// The colour of a label whose file gives it none: hues are well separated and fixed per value.
glm::dvec3 defaultLabelColour(std::uint16_t value);

}  // namespace fenestra
