#pragma once
// Collects a file's scalars in file order in the narrowest type that holds them exactly.

#include <cstddef>
#include <cstdint>
#include <span>

#include "rendering/volume/Voxels.h"

namespace fenestra::io {

/// The scalar types files have. Volumes have no 64-bit integers: those that fit no 32-bit type become Float64.
enum class ElementType : std::uint8_t { UInt8, Int8, UInt16, Int16, UInt32, Int32, UInt64, Int64, Float32, Float64 };
std::size_t sizeOf(ElementType type);

/// Calls f(T{}) with the C++ type of `type`.
template <class F>
decltype(auto) visitElement(ElementType type, F&& f) {
  switch (type) {
    case ElementType::UInt8:
      return f(std::uint8_t{});
    case ElementType::Int8:
      return f(std::int8_t{});
    case ElementType::UInt16:
      return f(std::uint16_t{});
    case ElementType::Int16:
      return f(std::int16_t{});
    case ElementType::UInt32:
      return f(std::uint32_t{});
    case ElementType::Int32:
      return f(std::int32_t{});
    case ElementType::UInt64:
      return f(std::uint64_t{});
    case ElementType::Int64:
      return f(std::int64_t{});
    case ElementType::Float32:
      return f(float{});
    case ElementType::Float64:
      break;
  }
  return f(double{});
}

/// Integers start as UInt8 and are widened when a block needs it; floats start as Float32. At most one and a half times
/// the final volume is in memory.
class VoxelSink {
 public:
  /// Room for `count` scalars. Check `count` against the file before: it is allocated.
  explicit VoxelSink(std::size_t count) : count_(count) {}

  template <class T>
  void append(std::span<const T> block);
  /// The collected voxels; `count` scalars must have been appended.
  Voxels take() { return std::move(voxels_); }
  /// Whether some 64-bit integer had no exact double.
  bool lossy() const { return lossy_; }

 private:
  void widen(ScalarType type);

  std::size_t count_, filled_ = 0;
  std::int64_t low_ = 0;  ///< least and greatest integer so far; every type holds 0
  std::uint64_t high_ = 0;
  bool lossy_ = false;
  Voxels voxels_;
};

/// The narrowest integer type that holds low..high, or Float64.
ScalarType narrowestInteger(std::int64_t low, std::uint64_t high);
/// Integer voxels in the narrowest type that holds them all; others as they are.
Voxels narrowed(Voxels voxels);

}  // namespace fenestra::io
