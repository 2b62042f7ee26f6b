#pragma once
// What a user must know of objects: those that are left out, and what the profile does not reach. Include in .cpp files
// alone.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::deidentify {

/// Why an object cannot be copied with its attributes cleaned and its pixels as they are; empty: it can.
std::string refusalOf(DcmFileFormat& object);

class Findings {
 public:
  void leaveOut(const std::string& reason, const std::vector<std::filesystem::path>& files);
  /// Notes what an object holds, as it was read; `facesGo`: Options::removeFace.
  void notice(DcmItem& object, const std::filesystem::path& file, bool facesGo);

  std::size_t leftOut() const;
  std::string firstReason() const;
  std::vector<Warning> warnings() const;

 private:
  std::map<std::string, std::vector<std::filesystem::path>> leftOut_, noticed_;  ///< by reason and by remark
};

}  // namespace fenestra::io::deidentify
