#pragma once
// The list of files that a DICOM medium carries (PS3.10 section 8, PS3.3 annex F).

#include <filesystem>
#include <vector>

namespace fenestra::io {

struct DicomDir {
  std::vector<std::filesystem::path> files;    ///< that its records in use refer to and that exist
  std::vector<std::filesystem::path> missing;  ///< that they refer to and that do not
};

/// Reads a DICOMDIR. Names are matched whatever their case, because media are copied by systems that change it. Both
/// lists are empty when the file has no records or cannot be read.
DicomDir readDicomDir(const std::filesystem::path& path);

}  // namespace fenestra::io
