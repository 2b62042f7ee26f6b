#pragma once
// Which encoding a file's transfer syntax names.

#include <cstdint>
#include <string>

#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// How the frames of a file are encoded. Encapsulated: uncompressed, but in fragments. Elscint: PMSCT_RLE1 of private
/// elements.
enum class Compression : std::uint8_t { Rle, Jpeg, JpegLs, Jpeg2000, Encapsulated, Elscint, Unknown };
/// The encoding of a file whose pixels are encapsulated or private, by its transfer syntax; DCMTK does not know those
/// that are younger than it, and calls them by the name of another.
Compression compressionOf(const DicomFile& file);
/// The name of a file's transfer syntax, or its UID where nothing here knows it.
std::string syntaxName(const DicomFile& file);

/// Whether decoded samples are those that were compressed.
bool isLossless(const DicomFile& file);

}  // namespace fenestra::io
