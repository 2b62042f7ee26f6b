#pragma once
// The first bytes of a file, which tell its format. Formats are asked one after the other; the file is opened once for
// them all, and once more where it is packed.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace fenestra::io {

class FileStart {
 public:
  static constexpr std::size_t mostBytes = 540;  ///< the longest header that is asked for, that of NIfTI-2

  /// Throws Error when the file cannot be read.
  explicit FileStart(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  /// The bytes as stored; fewer than mostBytes where the file is shorter.
  std::span<const std::byte> stored() const { return stored_; }
  /// The first bytes of what a gzip file holds; stored() of any other file. Throws Error when it cannot be unpacked.
  std::span<const std::byte> unpacked() const;

 private:
  std::filesystem::path path_;
  std::vector<std::byte> stored_;
  mutable std::optional<std::vector<std::byte>> unpacked_;
};

}  // namespace fenestra::io
