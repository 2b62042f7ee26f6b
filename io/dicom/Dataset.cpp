#include "io/dicom/Dataset.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/base/ByteStream.h"
#include "io/base/Error.h"
#include "io/base/Memory.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// DCMTK's parser calls itself once a level, so that a header of nothing but nested sequences would exhaust the stack.
/// Follows the item tags up to the pixel data and throws Error when they nest deeper than any real header, or a packed
/// header unpacks to more than any.
void refuseHostileHeader(const fs::path& path) {
  constexpr std::size_t deepest = 256;
  // DCMTK keeps all of a packed header in memory, of which a small file may unpack to gigabytes. Enhanced multi-frame
  // headers of thousands of frames have some 10 MB.
  constexpr std::uint64_t longestPackedHeader = 64'000'000;
  constexpr std::size_t tagAndLength = 8;
  constexpr std::uint64_t open = ~std::uint64_t{0};  // ends at a delimiter
  const DatasetStream dataset = openDataset(path);
  std::vector<unsigned char> bytes(64 * 1024);
  std::vector<std::uint64_t> ends;
  std::uint64_t start = 0;  // of `bytes` in the stream
  std::size_t kept = 0;
  while (const std::size_t got =
             dataset.bytes->read(reinterpret_cast<std::byte*>(bytes.data() + kept), bytes.size() - kept)) {
    if (dataset.deflated && start > longestPackedHeader)
      throw Error(path,
                  "its packed DICOM header unpacks to more than " + std::to_string(longestPackedHeader) + " bytes",
                  "the file is damaged");
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

/// All elements before `end`; `what` names them in the Error.
void loadUntil(const fs::path& path, const DcmTagKey& end, const char* what, DcmFileFormat& file) {
  prepareDcmtk();
  refuseHostileHeader(path);
  const OFCondition loaded = file.loadFileUntilTag(OFFilename(path.c_str()), EXS_Unknown, EGL_noChange,
                                                   DCM_MaxReadLength, ERM_autoDetect, end);
  if (loaded.bad())
    throw Error(path, std::string("its DICOM ") + what + " cannot be read (" + loaded.text() + ")",
                "the file is truncated or damaged");
}

}  // namespace

void loadHeader(const fs::path& path, DcmFileFormat& file) { loadUntil(path, DCM_FloatPixelData, "header", file); }

void loadObject(const fs::path& path, DcmFileFormat& file) {
  loadUntil(path, DcmTagKey(DCM_PixelData.getGroup(), static_cast<Uint16>(DCM_PixelData.getElement() + 1)), "object",
            file);
}

std::optional<PixelPlace> pixelsOf(DcmDataset& dataset, const fs::path& path) {
  const DcmXfer syntax(dataset.getOriginalXfer());
  return findPixels(path, {syntax.isExplicitVR() != 0, syntax.isBigEndian() != 0});
}

std::int64_t countFrames(DcmItem& dataset, const DicomFile& file) {
  const auto given = integerOf(dataset, DCM_NumberOfFrames);
  if (!given && !textOf(dataset, DCM_NumberOfFrames).empty())
    throw Error(file.path, "its header gives no number of frames", "the file is damaged");
  // Some writers count no frames where there is one.
  const std::int64_t frames = given.value_or(1) == 0 ? 1 : given.value_or(1);
  // The fewest bytes that a frame can take: its pixels, of which deflate packs at most 1032 into one byte, or the
  // header of its fragment.
  std::error_code failure;
  const std::uint64_t fileBytes = fs::file_size(file.path, failure);
  const std::uint64_t frameBits = static_cast<std::uint64_t>(file.format.rows) *
                                  static_cast<std::uint64_t>(file.format.columns) *
                                  static_cast<std::uint64_t>(file.format.bitsAllocated);
  const std::uint64_t leastBits = file.pixels.encapsulated || file.pixels.isPrivate ? 64
                                  : file.pixels.deflated                            ? frameBits / 1032
                                                                                    : frameBits;
  const auto refuse = [&](std::uint64_t bytes, const char* what) {
    throw Error(file.path,
                "holds " + std::to_string(bytes) + " bytes" + what + " where its header describes " +
                    std::to_string(frames) + (frames == 1 ? " frame of " : " frames of ") +
                    std::to_string(file.format.columns) + " x " + std::to_string(file.format.rows),
                "the file is truncated or damaged");
  };
  if (frames < 1 || saturatingProduct(static_cast<std::uint64_t>(frames), leastBits) / 8 > fileBytes)
    refuse(fileBytes, "");
  // Frames of one bit a pixel follow each other without padding.
  const std::uint64_t bits = saturatingProduct(static_cast<std::uint64_t>(frames), frameBits);
  const std::uint64_t needed = bits / 8 + (bits % 8 != 0);
  if (file.pixels.encapsulated || file.pixels.isPrivate) return frames;
  if (file.pixels.length < needed) refuse(file.pixels.length, " of pixels");
  if (!file.pixels.deflated && file.pixels.offset + needed > fileBytes)
    refuse(fileBytes - std::min(fileBytes, file.pixels.offset), " of pixels");
  return frames;
}

DcmItem* Scopes::group(const DcmTagKey& sequence) const {
  if (DcmItem* own = firstItem(perFrame, sequence)) return own;
  if (DcmItem* common = firstItem(shared, sequence)) return common;
  return perFrame || shared ? nullptr : &dataset;
}

}  // namespace fenestra::io
