#pragma once
// The bytes of files in order, unpacked on the way: what every reader of voxels reads from.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "io/base/Error.h"

namespace fenestra::io {

enum class Packing : std::uint8_t {
  None,
  Deflate,     ///< a zlib or a gzip stream
  RawDeflate,  ///< without either's header
  Bzip2
};

class ByteStream {
 public:
  virtual ~ByteStream() = default;
  /// Up to `size` bytes; fewer only at the end. Throws Error when the file cannot be read or unpacked; a packed stream
  /// that stops before its end mark, or whose checksum is wrong, is an error, told by the read that meets it.
  virtual std::size_t read(std::byte* into, std::size_t size) = 0;

  /// All of `size` bytes; throws Error naming `file` as truncated otherwise.
  void readAll(std::byte* into, std::size_t size, const std::filesystem::path& file);
  /// Drops bytes; stops at the end.
  void skip(std::uint64_t count);
};

/// The bytes of `file` from `offset` on, unpacked. Throws Error.
std::unique_ptr<ByteStream> openStream(const std::filesystem::path& file, std::uint64_t offset, Packing packing);
/// The bytes of `file`, unpacked when it starts as gzip does.
std::unique_ptr<ByteStream> openMaybeGzip(const std::filesystem::path& file);
bool isGzip(const std::filesystem::path& file);
bool startsAsGzip(std::span<const std::byte> bytes);

/// The system's words for the last failed call.
std::string systemCause();

}  // namespace fenestra::io
