#pragma once
// Archives that studies come in: zip and tar, and single files packed by gzip, bzip2 or xz. They are unpacked by
// libarchive.

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "io/base/FileStart.h"
#include "io/base/Reading.h"

namespace fenestra::io {

/// By the first bytes: zip, tar, or a stream of gzip, bzip2 or xz, whatever it holds.
bool looksLikeArchive(const FileStart& start);

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

/// A file of an archive, as UnpackedArchive::named() writes its path: "study.zip/labels/kidney.dcm".
struct ArchiveMember {
  std::filesystem::path archive, inside;
};
/// Empty unless `path` goes on behind a file.
std::optional<ArchiveMember> archiveMember(const std::filesystem::path& path);

/// Where messages name a file that was read as `unpacked`.
using FileNames = std::function<std::filesystem::path(const std::filesystem::path& unpacked)>;
void renameFiles(std::vector<Warning>& warnings, const FileNames& named);
/// In all that tells which files a volume came from.
void renameFiles(OpenedVolume& opened, const FileNames& named);

}  // namespace fenestra::io
