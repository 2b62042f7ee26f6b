#pragma once
// The files that are named for de-identification.

#include <filesystem>
#include <memory>
#include <vector>

#include "io/base/Archive.h"
#include "io/base/Reading.h"
#include "io/dicom/PackedFiles.h"

namespace fenestra::io::deidentify {

/// Files to read, from files, folders, DICOMDIRs and archives; what was unpacked lives as long as this object.
class Inputs {
 public:
  /// Throws Error for a path that is not there or a folder that cannot be listed, Cancelled.
  Inputs(const std::vector<std::filesystem::path>& paths, const Progress& progress);

  /// DICOM objects, in order.
  const std::vector<std::filesystem::path>& objects() const { return objects_; }
  const std::vector<std::filesystem::path>& others() const { return others_; }    ///< that are no DICOM objects
  const std::vector<std::filesystem::path>& missing() const { return missing_; }  ///< that a DICOMDIR lists
  /// How messages name a file.
  std::filesystem::path named(const std::filesystem::path& file) const;

 private:
  void add(const std::filesystem::path& path, bool mayBeArchive, const Progress& progress);
  void addFolder(const std::filesystem::path& folder, const Progress& progress);
  void addFile(const std::filesystem::path& file);

  std::vector<std::filesystem::path> objects_, others_, missing_;
  std::vector<std::unique_ptr<UnpackedArchive>> archives_;
  PackedFiles packed_;
};

}  // namespace fenestra::io::deidentify
