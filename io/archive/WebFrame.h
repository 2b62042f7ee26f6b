#pragma once
// One frame of an object with several (WADO-RS, PS3.18 10.4.1.1.6), so that it can be seen while the object, which
// comes as a whole, is on its way.

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/archive/WebServer.h"
#include "io/base/Reading.h"

namespace fenestra::io::archive {

struct FramePlace {
  std::string study, series, object;  ///< their UIDs
  int number = 1;                     ///< of the frame; the first one is 1
};

/// The largest frame asked for: a slice of 4096×4096 samples of 32 bits.
constexpr std::uint64_t mostFrameBytes = 64u << 20;

/// The frame as a DICOM image of its own, without anything of the patient, in `file`. False where the server gives no
/// such frame, or gives it in a form that was not asked for; no file is left then. Throws Error where the server cannot
/// be spoken to or the file cannot be written; Cancelled.
bool fetchFrame(const WebServer& server, const FramePlace& place, const std::filesystem::path& file,
                const Progress& progress = {});

}  // namespace fenestra::io::archive
