#include "io/base/VoxelSink.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace {

template <class T>
struct Extent {
  T low, high;
};

template <class T>
Extent<T> extentOf(std::span<const T> block) {
  Extent<T> extent{block[0], block[0]};
  for (const T value : block) {
    extent.low = std::min(extent.low, value);
    extent.high = std::max(extent.high, value);
  }
  return extent;
}

/// Whether a float holds the double; NaN counts as held.
bool exactAsFloat(double value) {
  if (!std::isfinite(value)) return true;
  return std::abs(value) <= std::numeric_limits<float>::max() &&
         static_cast<double>(static_cast<float>(value)) == value;
}

template <class From, class To>
void convert(std::span<const From> from, To* to) {
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<To>(from[i]);
}

/// Writes `from` into `voxels` at `offset` in the voxels' type, which must hold every value.
template <class From>
void store(std::span<const From> from, Voxels& voxels, std::size_t offset) {
  std::as_const(voxels).visit([&](auto scalars) {
    using To = typename decltype(scalars)::value_type;
    convert(from, voxels.as<std::remove_const_t<To>>().data() + offset);
  });
}

template <class T>
bool fits(std::int64_t low, std::uint64_t high) {
  return std::in_range<T>(low) && std::in_range<T>(high);
}

}  // namespace

std::size_t sizeOf(ElementType type) {
  return visitElement(type, [](auto scalar) { return sizeof scalar; });
}

ScalarType narrowestInteger(std::int64_t low, std::uint64_t high) {
  if (fits<std::uint8_t>(low, high)) return ScalarType::UInt8;
  if (fits<std::int8_t>(low, high)) return ScalarType::Int8;
  if (fits<std::uint16_t>(low, high)) return ScalarType::UInt16;
  if (fits<std::int16_t>(low, high)) return ScalarType::Int16;
  if (fits<std::uint32_t>(low, high)) return ScalarType::UInt32;
  if (fits<std::int32_t>(low, high)) return ScalarType::Int32;
  return ScalarType::Float64;
}

Voxels narrowed(Voxels voxels) {
  return std::as_const(voxels).visit([&](auto scalars) {
    using T = typename decltype(scalars)::value_type;
    if constexpr (std::is_floating_point_v<T>) {
      return std::move(voxels);
    } else {
      if (scalars.empty()) return std::move(voxels);
      const auto [low, high] = extentOf(scalars);
      const ScalarType type =
          narrowestInteger(std::min<std::int64_t>(low, 0), static_cast<std::uint64_t>(std::max<std::int64_t>(high, 0)));
      if (sizeOf(type) >= sizeOf(voxels.type())) return std::move(voxels);
      Voxels narrow(type, voxels.count());
      parallelFor(scalars.size(), 1 << 20, [&](std::size_t begin, std::size_t end) {
        store(scalars.subspan(begin, end - begin), narrow, begin);
      });
      return narrow;
    }
  });
}

void VoxelSink::widen(ScalarType type) {
  if (voxels_.count() != 0 && voxels_.type() == type) return;
  Voxels wide(type, count_);
  if (filled_ > 0) std::as_const(voxels_).visit([&](auto scalars) { store(scalars.first(filled_), wide, 0); });
  voxels_ = std::move(wide);
}

template <class T>
void VoxelSink::append(std::span<const T> block) {
  if (block.empty()) return;
  if constexpr (std::is_same_v<T, double>) {
    const bool isDouble = filled_ > 0 && voxels_.type() == ScalarType::Float64;
    widen(isDouble || !std::all_of(block.begin(), block.end(), exactAsFloat) ? ScalarType::Float64
                                                                             : ScalarType::Float32);
  } else if constexpr (std::is_same_v<T, float>) {
    widen(ScalarType::Float32);
  } else {
    const auto [low, high] = extentOf(block);
    if constexpr (std::is_signed_v<T>) low_ = std::min<std::int64_t>(low_, low);
    if (high > 0) high_ = std::max<std::uint64_t>(high_, high);
    widen(narrowestInteger(low_, high_));
    if constexpr (sizeof(T) == 8) {
      // 2^53: doubles hold every integer up to here.
      constexpr double exactLimit = 9007199254740992.0;
      if (voxels_.type() == ScalarType::Float64)
        for (const T value : block) {
          const double rounded = static_cast<double>(value);
          if (std::abs(rounded) >= exactLimit &&
              (rounded >= static_cast<double>(std::numeric_limits<T>::max()) || static_cast<T>(rounded) != value))
            lossy_ = true;
        }
    }
  }
  store(block, voxels_, filled_);
  filled_ += block.size();
}

template void VoxelSink::append(std::span<const std::uint8_t>);
template void VoxelSink::append(std::span<const std::int8_t>);
template void VoxelSink::append(std::span<const std::uint16_t>);
template void VoxelSink::append(std::span<const std::int16_t>);
template void VoxelSink::append(std::span<const std::uint32_t>);
template void VoxelSink::append(std::span<const std::int32_t>);
template void VoxelSink::append(std::span<const std::uint64_t>);
template void VoxelSink::append(std::span<const std::int64_t>);
template void VoxelSink::append(std::span<const float>);
template void VoxelSink::append(std::span<const double>);

}  // namespace fenestra::io
