#pragma once
// What anonymisers and converters do to the identifiers of images, put right.
//
// - A SOP Instance UID names one image (PS3.3 C.12.1.1.1). Files that share one are copies of an image where they give
//   the same place and hold the same pixels; the first is kept. Otherwise they are images of their own.
// - A Series Instance UID names a series (C.7.3.1.1.1). Series of a single slice each are joined where at least three
//   agree in study, frame of reference, kind of object, description, orientation, size and spacing, and lie evenly,
//   each at a place of its own.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

struct Identifiers {
  std::vector<std::filesystem::path> copies;                         ///< images that other files hold, too
  std::map<std::string, std::vector<std::filesystem::path>> shared;  ///< files of one SOP Instance UID, by their series
  std::map<std::string, std::size_t> joined;                         ///< how many series became one, by its UID
};

/// Drops copies from `files`, and gives series that are joined the UID of the first.
Identifiers mendIdentifiers(std::vector<DicomFile>& files);

/// One for each finding: copies, and what concerns the series `series`.
std::vector<Warning> warningsOf(const Identifiers& identifiers, const std::string& series);

}  // namespace fenestra::io
