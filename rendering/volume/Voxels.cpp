#include "rendering/volume/Voxels.h"

#include <limits>

namespace fenestra {

VoxelAllocationError::VoxelAllocationError(std::size_t bytes)
    : text_(std::make_shared<const std::string>("no memory for voxels of " + std::to_string(bytes / 1000000) +
                                                " MB in one piece")) {}

Voxels::Voxels(ScalarType type, std::size_t count) : type_(type), count_(count) {
  const std::size_t size = sizeOf(type);
  if (count > std::numeric_limits<std::ptrdiff_t>::max() / size)
    throw VoxelAllocationError(std::numeric_limits<std::ptrdiff_t>::max());
  try {
    bytes_ = std::make_unique_for_overwrite<std::byte[]>(count * size);
  } catch (const std::bad_alloc&) {
    throw VoxelAllocationError(count * size);
  }
}

std::size_t sizeOf(ScalarType type) {
  switch (type) {
    case ScalarType::UInt8:
    case ScalarType::Int8:
      return 1;
    case ScalarType::UInt16:
    case ScalarType::Int16:
      return 2;
    case ScalarType::UInt32:
    case ScalarType::Int32:
    case ScalarType::Float32:
      return 4;
    case ScalarType::Float64:
      break;
  }
  return 8;
}

const char* nameOf(ScalarType type) {
  switch (type) {
    case ScalarType::UInt8:
      return "uint8";
    case ScalarType::Int8:
      return "int8";
    case ScalarType::UInt16:
      return "uint16";
    case ScalarType::Int16:
      return "int16";
    case ScalarType::UInt32:
      return "uint32";
    case ScalarType::Int32:
      return "int32";
    case ScalarType::Float32:
      return "float32";
    case ScalarType::Float64:
      break;
  }
  return "float64";
}

}  // namespace fenestra
