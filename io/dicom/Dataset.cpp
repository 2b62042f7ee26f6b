#include "io/dicom/Dataset.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <dcmtk/dcmdata/dcspchrs.h>

#include "io/base/ByteStream.h"
#include "io/base/Error.h"
#include "io/base/Memory.h"
#include "io/base/Text.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// A file's bytes from the dataset on when that is deflated, else all of them.
std::unique_ptr<ByteStream> openDataset(const fs::path& path) {
  // Preamble, "DICM" and the group length element, whose value is the length of the rest of the meta header (PS3.10
  // 7.1).
  constexpr std::size_t metaStart = 144;
  std::array<char, 1024> head{};
  const auto stream = openStream(path, 0, Packing::None);
  const std::size_t got = stream->read(reinterpret_cast<std::byte*>(head.data()), head.size());
  const std::string_view text(head.data(), got);
  const bool deflated = text.find(UID_DeflatedExplicitVRLittleEndianTransferSyntax) != std::string_view::npos;
  if (!deflated || got < metaStart) return openStream(path, 0, Packing::None);
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < 4; ++i)
    length |= std::uint32_t{static_cast<unsigned char>(head[metaStart - 4 + i])} << (8 * i);
  return openStream(path, metaStart + length, Packing::RawDeflate);
}

/// DCMTK's parser calls itself once a level, so that a header of nothing but nested sequences would exhaust the stack.
/// Follows the item tags up to the pixel data and throws Error when they nest deeper than any real header.
void refuseDeepNesting(const fs::path& path) {
  constexpr std::size_t deepest = 256;
  constexpr std::size_t tagAndLength = 8;
  constexpr std::uint64_t open = ~std::uint64_t{0};  // ends at a delimiter
  const auto stream = openDataset(path);
  std::vector<unsigned char> bytes(64 * 1024);
  std::vector<std::uint64_t> ends;
  std::uint64_t start = 0;  // of `bytes` in the stream
  std::size_t kept = 0;
  while (const std::size_t got = stream->read(reinterpret_cast<std::byte*>(bytes.data() + kept), bytes.size() - kept)) {
    const std::size_t filled = kept + got;
    std::size_t at = 0;
    for (; at + tagAndLength <= filled; ++at) {
      const unsigned char* b = bytes.data() + at;
      const bool little = b[0] == 0xfe && b[1] == 0xff && b[3] == 0xe0,
                 big = b[0] == 0xff && b[1] == 0xfe && b[2] == 0xe0;
      if (little || big) {
        const unsigned char element = little ? b[2] : b[3];
        std::uint64_t length = 0;
        for (int i = 0; i < 4; ++i) length |= std::uint64_t{b[4 + i]} << 8 * (little ? i : 3 - i);
        while (!ends.empty() && ends.back() <= start + at) ends.pop_back();
        if (element == 0x0d && !ends.empty()) ends.pop_back();
        if (element == 0x00) ends.push_back(length == 0xffffffff ? open : start + at + tagAndLength + length);
        if (ends.size() > deepest)
          throw Error(path, "its DICOM header nests deeper than " + std::to_string(deepest) + " levels",
                      "the file is damaged");
      }
      const bool pixels = (b[0] == 0xe0 && b[1] == 0x7f && b[2] == 0x10 && b[3] == 0x00) ||
                          (b[0] == 0x7f && b[1] == 0xe0 && b[2] == 0x00 && b[3] == 0x10);
      if (!pixels) continue;
      while (!ends.empty() && ends.back() <= start + at) ends.pop_back();
      if (ends.empty()) return;
    }
    std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.begin() + static_cast<std::ptrdiff_t>(filled),
              bytes.begin());
    start += at;
    kept = filled - at;
  }
}

}  // namespace

void loadHeader(const fs::path& path, DcmFileFormat& file) {
  prepareDcmtk();
  refuseDeepNesting(path);
  const OFCondition loaded = file.loadFileUntilTag(OFFilename(path.c_str()), EXS_Unknown, EGL_noChange,
                                                   DCM_MaxReadLength, ERM_autoDetect, DCM_PixelData);
  if (loaded.bad())
    throw Error(path, std::string("its DICOM header cannot be read (") + loaded.text() + ")",
                "the file is truncated or damaged");
}

void checkFrameBytes(DcmDataset& dataset, const fs::path& path, std::int64_t frames, int rows, int columns, int bits) {
  // The fewest bytes that a frame can take: its pixels, of which deflate packs at most 1032 into one byte, or the
  // header of its fragment.
  std::error_code failure;
  const std::uint64_t fileBytes = fs::file_size(path, failure);
  const std::uint64_t frameBits =
      static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(bits);
  const bool encapsulated = DcmXfer(dataset.getOriginalXfer()).isEncapsulated();
  const bool deflated = dataset.getOriginalXfer() == EXS_DeflatedLittleEndianExplicit;
  const std::uint64_t leastBits = encapsulated ? 64 : deflated ? frameBits / 1032 : frameBits;
  if (frames < 1 || saturatingProduct(static_cast<std::uint64_t>(frames), leastBits) / 8 > fileBytes)
    throw Error(path,
                "holds " + std::to_string(fileBytes) + " bytes where its header describes " + std::to_string(frames) +
                    " frames of " + std::to_string(columns) + " x " + std::to_string(rows),
                "the file is truncated or damaged");
}

std::optional<double> number(DcmItem& item, const DcmTagKey& tag, unsigned long position) {
  Float64 value = 0.0;
  if (item.findAndGetFloat64(tag, value, position).bad() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::int64_t> integer(DcmItem& item, const DcmTagKey& tag) {
  Uint16 us = 0;
  if (item.findAndGetUint16(tag, us).good()) return us;
  Uint32 ul = 0;
  if (item.findAndGetUint32(tag, ul).good()) return ul;
  long is = 0;
  if (item.findAndGetLongInt(tag, is).good()) return is;
  return std::nullopt;
}

std::string text(DcmItem& item, const DcmTagKey& tag) {
  OFString value;
  return item.findAndGetOFStringArray(tag, value).good() ? trimmed({value.data(), value.size()}) : std::string();
}

std::string typedText(DcmItem& item, const DcmTagKey& tag, DcmItem* dataset) {
  OFString value, utf8;
  if (item.findAndGetOFStringArray(tag, value).bad()) return {};
  DcmSpecificCharacterSet converter;
  const bool converted =
      converter.selectCharacterSet(dataset ? *dataset : item).good() && converter.convertString(value, utf8).good();
  std::string result =
      trimmed(converted ? std::string_view(utf8.data(), utf8.size()) : std::string_view(value.data(), value.size()));
  if (!converted) std::erase_if(result, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  return result;
}

DcmItem* firstItem(DcmItem* item, const DcmTagKey& sequence) {
  DcmItem* found = nullptr;
  return item && item->findAndGetSequenceItem(sequence, found, 0).good() ? found : nullptr;
}

DcmItem* Scopes::group(const DcmTagKey& sequence) const {
  if (DcmItem* own = firstItem(perFrame, sequence)) return own;
  if (DcmItem* common = firstItem(shared, sequence)) return common;
  return perFrame || shared ? nullptr : &dataset;
}

void readGeometry(const Scopes& scopes, DicomFrame& frame) {
  DcmItem* measures = scopes.group(DCM_PixelMeasuresSequence);
  if (measures) {
    auto spacing = numbers<2>(*measures, DCM_PixelSpacing);
    if (!spacing) spacing = numbers<2>(*measures, DCM_ImagerPixelSpacing);
    // Pixel Spacing is (between rows, between columns).
    if (spacing && spacing->x > 0.0 && spacing->y > 0.0) frame.spacing = {spacing->y, spacing->x};
    frame.thickness = std::max(0.0, number(*measures, DCM_SliceThickness).value_or(0.0));
    if (frame.thickness == 0.0) frame.thickness = std::abs(number(*measures, DCM_SpacingBetweenSlices).value_or(0.0));
  }
  DcmItem* place = scopes.group(DCM_PlanePositionSequence);
  DcmItem* plane = scopes.group(DCM_PlaneOrientationSequence);
  if (!place || !plane) return;
  const auto position = numbers<3>(*place, DCM_ImagePositionPatient);
  glm::dvec3 row(0.0), column(0.0);
  for (unsigned i = 0; i < 3; ++i) {
    row[static_cast<int>(i)] = number(*plane, DCM_ImageOrientationPatient, i).value_or(0.0);
    column[static_cast<int>(i)] = number(*plane, DCM_ImageOrientationPatient, i + 3).value_or(0.0);
  }
  // Direction cosines are unit vectors at right angles; a damaged pair cannot place the image.
  const bool usable = std::abs(glm::length(row) - 1.0) < 0.1 && std::abs(glm::length(column) - 1.0) < 0.1 &&
                      std::abs(glm::dot(row, column)) < 0.1;
  if (!position || !usable) return;
  frame.hasGeometry = true;
  frame.position = *position;
  frame.axes = glm::dmat2x3(glm::normalize(row), glm::normalize(column));
}

}  // namespace fenestra::io
