#pragma once
// The headers of a file, a folder or a DICOMDIR, sorted by what can be done with them.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomFile.h"
#include "io/dicom/Identifiers.h"
#include "io/dicom/PackedFiles.h"
#include "io/dicom/SharedProgress.h"

namespace fenestra::io {

struct DicomScan {
  std::vector<DicomFile> files;  ///< images
  std::vector<std::filesystem::path> unreadable;
  std::vector<std::string> unreadableCauses;
  std::vector<std::filesystem::path> closed;     ///< folders that cannot be listed
  std::vector<std::filesystem::path> notImages;  ///< other files of the folder
  std::map<std::string, std::vector<std::filesystem::path>>
      refused;                                 ///< DICOM objects that are no scalar images, by reason
  std::vector<DicomFile> segmentations;        ///< and structure sets
  Identifiers identifiers;                     ///< what was wrong with those of the images
  std::vector<std::filesystem::path> missing;  ///< listed in the DICOMDIR that was opened
};

/// Throws Error when there is no image, Cancelled.
DicomScan scanHeaders(const std::filesystem::path& path, const ProgressPart& progress, PackedFiles& packed);

/// What was left out or guessed, for a volume of the series `series`.
void addScanWarnings(const DicomScan& scan, const std::string& series, std::vector<Warning>& warnings);

}  // namespace fenestra::io
