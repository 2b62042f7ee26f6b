#pragma once
// Headers loaded with care, and what they say about frames: what the readers of images, segmentations and structure
// sets share. Include in .cpp files alone.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Everything before the pixel data. Throws Error when the file is no DICOM file, is damaged, or nests too deep.
void loadHeader(const std::filesystem::path& path, DcmFileFormat& file);
/// As loadHeader, with the pixel data, whose values stay in the file until they are asked for. What stands behind them is
/// left out.
void loadObject(const std::filesystem::path& path, DcmFileFormat& file);
/// findPixels for a header that was loaded.
std::optional<PixelPlace> pixelsOf(DcmDataset& dataset, const std::filesystem::path& path);
/// How many frames the header describes, of the file's format and pixels. Throws Error when the file cannot hold them.
std::int64_t countFrames(DcmItem& dataset, const DicomFile& file);

/// The places a frame's attributes may be: its own functional groups, the shared ones, the dataset itself.
struct Scopes {
  DcmItem* perFrame = nullptr;
  DcmItem* shared = nullptr;
  DcmItem& dataset;

  /// The functional group `sequence` for this frame; without groups, the dataset that holds the same attributes.
  DcmItem* group(const DcmTagKey& sequence) const;
};

}  // namespace fenestra::io
