#pragma once
// A small picture of a series, as a server of DICOMweb draws it (WADO-RS, PS3.18 10.4.1.1.3 and 10.4.1.1.4).

#include <cstddef>
#include <optional>
#include <string>

#include "io/archive/WebServer.h"
#include "io/base/Reading.h"

namespace fenestra::io::archive {

struct WebPicture {
  std::string bytes;  ///< of a JPEG or PNG; nothing else is known of them
  /// Text in the pixels may name the patient: true unless the server says that there is none, or the image is a slice
  /// as a scanner of CT, MR or PET made it.
  bool couldShowNames = true;
};

/// The middle object, by its number, of a series of `objects`, drawn to fit `side` pixels where the server scales.
/// Empty where the server draws none of it. Throws Error where the server cannot be spoken to; Cancelled.
std::optional<WebPicture> pictureOf(const WebServer& server, const std::string& study, const std::string& series,
                                    std::size_t objects, int side, const Progress& progress = {});

/// Whether the pixels of an object may hold text that names the patient, by the values of its attributes Burned In
/// Annotation, SOP Class UID and Image Type (PS3.3 C.7.6.1.1.2, several between backslashes).
bool couldShowNames(const std::string& burnedIn, const std::string& objectClass, const std::string& imageType);

}  // namespace fenestra::io::archive
