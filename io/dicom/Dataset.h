#pragma once
// Values out of DCMTK's datasets, and headers loaded with care: what the readers of images, segmentations and structure
// sets share. Include in .cpp files alone.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomHeader.h"

namespace fenestra::io {

/// Everything before the pixel data. Throws Error when the file is no DICOM file, is damaged, or nests too deep.
void loadHeader(const std::filesystem::path& path, DcmFileFormat& file);

/// Throws Error when the file is too short for `frames` (at least one) of `bits` a pixel, packed or compressed as its
/// transfer syntax says.
void checkFrameBytes(DcmDataset& dataset, const std::filesystem::path& path, std::int64_t frames, int rows, int columns,
                     int bits);

/// A finite number; nothing when it is missing.
std::optional<double> number(DcmItem& item, const DcmTagKey& tag, unsigned long position = 0);
std::optional<std::int64_t> integer(DcmItem& item, const DcmTagKey& tag);
template <int N>
std::optional<glm::vec<N, double>> numbers(DcmItem& item, const DcmTagKey& tag) {
  glm::vec<N, double> result;
  for (int i = 0; i < N; ++i) {
    const auto value = number(item, tag, static_cast<unsigned long>(i));
    if (!value) return std::nullopt;
    result[i] = *value;
  }
  return result;
}
std::string text(DcmItem& item, const DcmTagKey& tag);
/// Text that an operator typed, as UTF-8; of an unknown character set only the ASCII part. `dataset` names the
/// character set where `item` is nested in it.
std::string typedText(DcmItem& item, const DcmTagKey& tag, DcmItem* dataset = nullptr);
/// The first item of a sequence; null when there is none, or `item` is null.
DcmItem* firstItem(DcmItem* item, const DcmTagKey& sequence);
/// Calls f(item) for the items of a sequence in their order.
template <class F>
void forEachItem(DcmItem& parent, const DcmTagKey& tag, F&& f) {
  DcmSequenceOfItems* sequence = nullptr;
  if (parent.findAndGetSequence(tag, sequence).bad() || !sequence) return;
  for (DcmObject* next = nullptr; (next = sequence->nextInContainer(next));)
    if (auto* item = dynamic_cast<DcmItem*>(next)) f(*item);
}

/// The places a frame's attributes may be: its own functional groups, the shared ones, the dataset itself.
struct Scopes {
  DcmItem* perFrame = nullptr;
  DcmItem* shared = nullptr;
  DcmItem& dataset;

  /// The functional group `sequence` for this frame; without groups, the dataset that holds the same attributes.
  DcmItem* group(const DcmTagKey& sequence) const;
};

/// Position, axes, spacing and thickness of a frame, as far as its groups say.
void readGeometry(const Scopes& scopes, DicomFrame& frame);

}  // namespace fenestra::io
