#pragma once
// Archives that studies come in: zip and tar, and single files packed by gzip, bzip2 or xz. They are unpacked by
// libarchive.

#include <filesystem>

#include "io/base/Reading.h"

namespace fenestra::io {

/// By the first bytes: zip, tar, or a stream of gzip, bzip2 or xz, whatever it holds.
bool looksLikeArchive(const std::filesystem::path& path);

/// An archive's files in a private temporary folder, which is removed with this object.
class UnpackedArchive {
 public:
  /// What unpacks to more than this many times the archive's bytes, and more than `freely` bytes, is refused: no study
  /// is packed that tightly, and a few kilobytes would fill the disk otherwise.
  static constexpr std::uint64_t mostGrowth = 200, freely = 64u << 20;
  static constexpr std::size_t mostFiles = 200'000;

  /// Links, devices and paths that lead out of the folder are left out. Throws Error, Cancelled.
  explicit UnpackedArchive(std::filesystem::path archive, const Progress& progress = {});
  ~UnpackedArchive();
  UnpackedArchive(const UnpackedArchive&) = delete;
  UnpackedArchive& operator=(const UnpackedArchive&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// How messages name an unpacked file: its path in the archive behind the archive's. Other paths stay.
  std::filesystem::path named(const std::filesystem::path& unpacked) const;

 private:
  void unpack(const Progress& progress);

  std::filesystem::path archive_, folder_;
};

}  // namespace fenestra::io
