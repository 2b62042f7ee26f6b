#pragma once
// MGH files of known content.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "tests/io/IoTesting.h"

namespace fenestra::tests {

/// An MGH file, field by field as the FreeSurfer wiki's "MghFormat" lists them.
struct MghSpec {
  std::int32_t version = 1, type = 4, frames = 1;
  glm::ivec3 dims{2, 3, 4};
  bool hasGeometry = true;
  glm::vec3 spacing{1.0f};
  glm::mat3 axes{{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}};  // RAS directions, one a column
  glm::vec3 centre{0.0f};                             // RAS
};

template <class T>
std::string mghFile(const MghSpec& spec, const std::vector<T>& voxels) {
  constexpr bool swapped = true;  // big-endian on this machine
  std::string bytes;
  for (const std::int32_t value :
       {spec.version, spec.dims.x, spec.dims.y, spec.dims.z, spec.frames, spec.type, std::int32_t{0}})
    bytes += bytesOf(value, swapped);
  bytes += bytesOf(static_cast<std::int16_t>(spec.hasGeometry), swapped);
  for (int i = 0; i < 3; ++i) bytes += bytesOf(spec.spacing[i], swapped);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i) bytes += bytesOf(spec.axes[axis][i], swapped);
  for (int i = 0; i < 3; ++i) bytes += bytesOf(spec.centre[i], swapped);
  bytes.resize(284);
  return bytes + bytesOf(voxels, swapped);
}

}  // namespace fenestra::tests
