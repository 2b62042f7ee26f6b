#pragma once
// Voxels that are written as text.

#include <cstdint>
#include <filesystem>
#include <memory>

#include "io/base/ByteStream.h"
#include "io/base/VoxelSink.h"

namespace fenestra::io {

/// Decimal numbers, divided by blanks, line ends or commas, as scalars of one type in this machine's byte order.
/// `count` is how many the header describes; errors name `path`.
std::unique_ptr<ByteStream> decimalScalars(std::unique_ptr<ByteStream> source, ElementType type, std::uint64_t count,
                                           const std::filesystem::path& path);
/// Bytes written as two hexadecimal digits each; blanks and line ends between them are skipped.
std::unique_ptr<ByteStream> hexadecimalBytes(std::unique_ptr<ByteStream> source, const std::filesystem::path& path);

}  // namespace fenestra::io
