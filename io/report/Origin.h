#pragma once
// Where a result belongs: the patient and study of its source, copied; and how it is saved. Include in .cpp files
// alone.

#include <filesystem>
#include <string>

#include "io/dicom/Dcmtk.h"

namespace fenestra::io::report {

/// The patient, study and frame of reference of a result.
struct Origin {
  DcmFileFormat file;                   ///< the header of the source, as UTF-8; of a new study when there is none
  std::string study, frameOfReference;  ///< UIDs; the second may be empty
  DcmDataset& dataset() { return *file.getDataset(); }
};

/// Reads the header of a source; an empty path: a new study of an unnamed patient.
void readOrigin(const std::filesystem::path& source, Origin& origin);

/// A new UID.
std::string newUid();
/// The text as UTF-8 without control characters but line breaks, of at most so many characters.
std::string bounded(const std::string& text, std::size_t characters);
/// The text on one line without backslashes, as a long string (LO) holds it: at most 64 characters.
std::string longString(const std::string& text);

/// Throws Error naming `file` when DCMTK refused.
void require(const OFCondition& condition, const std::filesystem::path& file, const char* what);
/// Saves beside and renames.
void save(DcmFileFormat& whole, const std::filesystem::path& file);

}  // namespace fenestra::io::report
