#pragma once
// Files that people take for volumes and that no reader of volumes reads, told by their first bytes, so that messages
// name them and say what to do.

#include <cstddef>
#include <span>

namespace fenestra::io {

struct OtherContent {
  const char* one;   ///< "a PNG picture"
  const char* many;  ///< "PNG pictures"
  const char* way;   ///< out, for Error
};

/// Null for other contents. `start` are the first bytes of a file, FileStart::stored().
const OtherContent* otherContentOf(std::span<const std::byte> start);

}  // namespace fenestra::io
