#pragma once
// Files of a DICOM folder that are packed one by one: slice1.dcm.gz, slice2.dcm.gz, …

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "io/base/Archive.h"

namespace fenestra::io {

/// Keeps packed files unpacked, in a private temporary folder each, for as long as it lives.
class PackedFiles {
 public:
  /// The unpacked file of a DICOM file that gzip packed; other paths come back as they are. Any thread may call it.
  /// Throws Error when the file cannot be unpacked.
  std::filesystem::path contentOf(const std::filesystem::path& file);
  /// The packed file of an unpacked one; other paths come back as they are.
  std::filesystem::path named(const std::filesystem::path& file) const;

 private:
  struct Unpacked {
    std::filesystem::path packed;
    std::unique_ptr<UnpackedArchive> archive;
  };
  std::mutex mutex_;
  std::map<std::filesystem::path, Unpacked> unpacked_;  ///< by the folder
};

}  // namespace fenestra::io
