#pragma once
// Whether what a file describes fits this machine, asked before it is allocated.

#include <cstdint>
#include <filesystem>
#include <new>

#include "io/base/Error.h"
#include "rendering/volume/Voxels.h"

namespace fenestra::io {

/// Throws Error when `bytes` is more than this machine's memory.
void checkMemory(const std::filesystem::path& path, std::uint64_t bytes);
/// a·b, or the greatest number when it overflows.
std::uint64_t saturatingProduct(std::uint64_t a, std::uint64_t b);

/// read(), with an allocation that fails as an Error.
template <class F>
auto withinMemory(const std::filesystem::path& path, F&& read) {
  try {
    return read();
  } catch (const VoxelAllocationError& error) {
    throw Error(path, error.what(), "close other programs, or make the volume smaller first");
  } catch (const std::bad_alloc&) {
    throw Error(path, "needs more memory than is free", "close other programs, or make the volume smaller first");
  }
}

}  // namespace fenestra::io
