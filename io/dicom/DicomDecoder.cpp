#include "io/dicom/DicomDecoder.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "io/base/Error.h"
#include "io/dicom/CodecError.h"
#include "io/dicom/DicomCodecs.h"
#include "io/dicom/StoredIntegers.h"
#include "io/dicom/TransferSyntax.h"

namespace fenestra::io {
namespace {

/// Samples with other bits set above Bits Stored than those of their sign, or outside `limits`. Uncompressed files may
/// keep overlays in these bits; a compressed sample that does not fit was decoded wrongly, or its header is wrong.
template <class Word>
std::size_t countOutside(std::span<const std::byte> words, const PixelFormat& format,
                         const std::optional<ValueLimits>& limits) {
  const auto above = static_cast<Word>(~((std::uint64_t{2} << format.highBit) - 1));
  const auto sign = static_cast<Word>(std::uint64_t{1} << format.highBit);
  const StoredIntegers<Word> stored(format);
  std::size_t outside = 0;
  for (std::size_t at = 0; at < words.size(); at += sizeof(Word)) {
    Word word{};
    std::memcpy(&word, words.data() + at, sizeof word);
    const auto excess = static_cast<Word>(word & above);
    const bool extendsSign = format.isSigned && excess == above && (word & sign) != 0;
    outside += (excess != 0 && !extendsSign) || (limits && !limits->contain(stored(word)));
  }
  return outside;
}

std::size_t countOutside(std::span<const std::byte> words, const PixelFormat& format,
                         const std::optional<ValueLimits>& limits) {
  switch (format.bitsAllocated) {
    case 8:
      return countOutside<std::uint8_t>(words, format, limits);
    case 16:
      return countOutside<std::uint16_t>(words, format, limits);
    default:
      return countOutside<std::uint32_t>(words, format, limits);
  }
}

}  // namespace

DicomDecoder::DicomDecoder(const DicomFile& file) : file_(file), native_(file.path, file.pixels) {
  if (file.format.frameBytes() >= std::numeric_limits<std::uint32_t>::max())
    throw Error(file.path, "its pixels cannot be read (frames of more than 4 GB)", "the file is damaged");
  if (!file.pixels.encapsulated) return;
  if (compressionOf(file) == Compression::Unknown)
    throw Error(file.path, "its transfer syntax is not supported (" + syntaxName(file) + ")",
                "convert it to an uncompressed or lossless JPEG, JPEG-LS, JPEG 2000 or RLE file");
  std::size_t frames = 0;
  for (const DicomFrame& frame : file.frames) frames = std::max(frames, static_cast<std::size_t>(frame.number) + 1);
  fragments_.emplace(file.path, file.pixels, frames);
}

void DicomDecoder::readNative(std::uint64_t frame, std::span<std::byte> words) {
  native_.read(frame * words.size(), words);
  if constexpr (std::endian::native == std::endian::big) {
    const auto wordBytes = static_cast<std::ptrdiff_t>(file_.format.bitsAllocated / 8);
    for (auto word = words.begin(); word != words.end(); word += wordBytes) std::reverse(word, word + wordBytes);
  }
}

std::vector<std::uint8_t> DicomDecoder::codestream(int number) {
  if (fragments_) return fragments_->frame(static_cast<std::size_t>(number));
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(file_.pixels.length));
  native_.read(0, std::as_writable_bytes(std::span(bytes)));
  return bytes;
}

std::span<const std::byte> DicomDecoder::decode(int number) {
  // Not cleared: every byte is written.
  const std::size_t frameBytes = file_.format.frameBytes();
  if (!words_) words_ = std::make_unique_for_overwrite<std::byte[]>(frameBytes);
  const std::span<std::byte> words(words_.get(), frameBytes);
  if (!fragments_ && !file_.pixels.isPrivate) {
    readNative(static_cast<std::uint64_t>(number), words);
    return words;
  }
  try {
    bytesBehind_ = decodeFrame(codestream(number), file_, words).bytesBehind;
  } catch (const CodecError& error) {
    throw Error(file_.path,
                "the pixels of frame " + std::to_string(number + 1) + " cannot be decoded (" + error.what() + ")",
                "the file is truncated or damaged");
  }
  // What lossy compression changes may well lie outside the original's limits.
  samplesOutside_ = countOutside(words, file_.format, isLossless(file_) ? file_.limits : std::nullopt);
  return words;
}

}  // namespace fenestra::io
