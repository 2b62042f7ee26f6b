#pragma once
// De-identified copies of DICOM objects: their attributes by the Basic Application Level Confidentiality Profile of
// PS3.15, their pixels as they are, to the bit, unless faces are taken out of them.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "io/deidentify/Changes.h"
#include "io/deidentify/Profile.h"

namespace fenestra::io::deidentify {

struct Request {
  std::vector<std::filesystem::path> inputs = {};  ///< files, folders, DICOMDIRs, archives
  std::filesystem::path output = {};  ///< a folder that does not exist or is empty; empty: nothing is written
  std::filesystem::path map =
      {};  ///< old and new UIDs and patients' numbers, for its owner alone; empty: they are forgotten
  Options options = {};
  bool values = false;  ///< Outcome::changes tells what was there
};

struct Outcome {
  Changes changes{false};
  std::size_t objects = 0;
  std::map<std::string, std::size_t> series;  ///< objects of each, by its new UID
  std::size_t leftOut = 0;                    ///< files that are not in the output
  std::size_t faces = 0;                      ///< objects whose pixels lost a face
  std::vector<Warning> warnings;
};

/// Writes OUTPUT/SERIES/INSTANCE.dcm, named by the new UIDs. UIDs are replaced alike in all objects, so that references
/// among them hold. All objects are written beside the folder, which appears as a whole, with the permissions of its
/// owner alone. With Options::removeFace, images are left out of which no face can be taken. Throws Error where there
/// is no object, or something cannot be written; Cancelled.
Outcome deidentify(const Request& request, const Progress& progress = {});

}  // namespace fenestra::io::deidentify
