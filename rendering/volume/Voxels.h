#pragma once
// A typed, uninitialised-on-allocation array of scalars whose type is known at run time.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace fenestra {

enum class ScalarType : std::uint8_t { UInt8, Int8, UInt16, Int16, UInt32, Int32, Float32, Float64 };

std::size_t sizeOf(ScalarType type);
/// "uint8", "int16", "float32", …
const char* nameOf(ScalarType type);

template <class T>
constexpr ScalarType scalarTypeOf() {
  if constexpr (std::is_same_v<T, std::uint8_t>)
    return ScalarType::UInt8;
  else if constexpr (std::is_same_v<T, std::int8_t>)
    return ScalarType::Int8;
  else if constexpr (std::is_same_v<T, std::uint16_t>)
    return ScalarType::UInt16;
  else if constexpr (std::is_same_v<T, std::int16_t>)
    return ScalarType::Int16;
  else if constexpr (std::is_same_v<T, std::uint32_t>)
    return ScalarType::UInt32;
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return ScalarType::Int32;
  else if constexpr (std::is_same_v<T, float>)
    return ScalarType::Float32;
  else {
    static_assert(std::is_same_v<T, double>, "not a voxel type");
    return ScalarType::Float64;
  }
}

/// There is no memory for so many voxels; what() names the size.
class VoxelAllocationError : public std::bad_alloc {
 public:
  explicit VoxelAllocationError(std::size_t bytes);
  const char* what() const noexcept override { return text_->c_str(); }

 private:
  std::shared_ptr<const std::string> text_;  ///< shared, because copying an exception must not throw
};

/// Move-only storage of `count` scalars of one type. Freshly allocated memory is not cleared: a volume of gigabytes is
/// written once, by the reader.
class Voxels {
 public:
  Voxels() = default;
  /// Throws VoxelAllocationError.
  Voxels(ScalarType type, std::size_t count);

  ScalarType type() const { return type_; }
  std::size_t count() const { return count_; }
  std::size_t byteCount() const { return count_ * sizeOf(type_); }
  std::byte* data() { return bytes_.get(); }
  const std::byte* data() const { return bytes_.get(); }

  /// The scalars as T; T must be the stored type.
  template <class T>
  std::span<T> as() {
    return {reinterpret_cast<T*>(bytes_.get()), count_};
  }
  template <class T>
  std::span<const T> as() const {
    return {reinterpret_cast<const T*>(bytes_.get()), count_};
  }

  /// Calls f(std::span<const T>) with the stored type T and returns its result.
  template <class F>
  decltype(auto) visit(F&& f) const {
    switch (type_) {
      case ScalarType::UInt8:
        return std::forward<F>(f)(as<std::uint8_t>());
      case ScalarType::Int8:
        return std::forward<F>(f)(as<std::int8_t>());
      case ScalarType::UInt16:
        return std::forward<F>(f)(as<std::uint16_t>());
      case ScalarType::Int16:
        return std::forward<F>(f)(as<std::int16_t>());
      case ScalarType::UInt32:
        return std::forward<F>(f)(as<std::uint32_t>());
      case ScalarType::Int32:
        return std::forward<F>(f)(as<std::int32_t>());
      case ScalarType::Float32:
        return std::forward<F>(f)(as<float>());
      case ScalarType::Float64:
        break;
    }
    return std::forward<F>(f)(as<double>());
  }

 private:
  ScalarType type_ = ScalarType::UInt8;
  std::size_t count_ = 0;
  std::unique_ptr<std::byte[]> bytes_;
};

}  // namespace fenestra
