#include "io/base/FileStart.h"

#include <utility>

#include "io/base/ByteStream.h"

namespace fenestra::io {
namespace {

std::vector<std::byte> firstBytes(const std::filesystem::path& path, Packing packing) {
  std::vector<std::byte> bytes(FileStart::mostBytes);
  bytes.resize(openStream(path, 0, packing)->read(bytes.data(), bytes.size()));
  return bytes;
}

}  // namespace

FileStart::FileStart(std::filesystem::path path) : path_(std::move(path)), stored_(firstBytes(path_, Packing::None)) {}

std::span<const std::byte> FileStart::unpacked() const {
  if (!startsAsGzip(stored_)) return stored_;
  if (!unpacked_) unpacked_ = firstBytes(path_, Packing::Deflate);
  return *unpacked_;
}

}  // namespace fenestra::io
