#pragma once
// Objects sent to an archive (C-STORE, PS3.4 annex B), with its answer to each.

#include <filesystem>
#include <string>
#include <vector>

#include "io/archive/Server.h"
#include "io/base/Reading.h"

namespace fenestra::io::archive {

/// What became of one file.
struct Sent {
  std::filesystem::path file;
  std::string object;            ///< its SOP Instance UID
  std::string objectClass = {};  ///< its SOP Class UID; empty after DICOMweb
  bool accepted = false;
  unsigned status = 0;  ///< of C-STORE, or of HTTP; 0 where nothing was asked
  std::string text;     ///< why it was not accepted, or a warning of the server; empty: neither
};

/// The DICOM files among `paths`, and in folders among them; other files are left out. Throws Error for a path that is
/// not there.
std::vector<std::filesystem::path> filesToSend(const std::vector<std::filesystem::path>& paths);

/// The SOP Instance UID of a DICOM file. Throws Error.
std::string objectOf(const std::filesystem::path& file);

/// Sends files as they are; where the server does not take a file's compression, its pixels are sent uncompressed. One
/// file that the server refuses stops no other. Throws Error when nothing more can be sent, Cancelled.
std::vector<Sent> send(const Server& server, const std::vector<std::filesystem::path>& files,
                       const Progress& progress = {});

}  // namespace fenestra::io::archive
