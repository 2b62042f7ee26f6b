#pragma once
// DICOM files by their beginning.

#include "io/base/FileStart.h"

namespace fenestra::io {

/// Whether a file holds a DICOM dataset, with or without the preamble.
bool looksLikeDicom(const FileStart& start);

}  // namespace fenestra::io
