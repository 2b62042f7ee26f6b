#pragma once
// Stored frames of one DICOM file as words, whatever their transfer syntax.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "io/dicom/DicomFile.h"
#include "io/dicom/DicomPixels.h"

namespace fenestra::io {

/// One file; use one decoder from one thread.
class DicomDecoder {
 public:
  /// Throws Error when the file cannot be read or its transfer syntax is not supported. `file` must outlive this.
  explicit DicomDecoder(const DicomFile& file);

  /// The words of stored frame `number` in this machine's byte order, rows · columns of bitsAllocated bits, unused bits
  /// as stored; valid until the next call. Throws Error.
  std::span<const std::byte> decode(int number);
  /// How many samples of the last compressed frame the header rules out, by Bits Stored or by its least and greatest
  /// value.
  std::size_t samplesOutside() const { return samplesOutside_; }
  /// How many bytes of the last frame stand behind its last RLE run and are no padding.
  std::size_t bytesBehind() const { return bytesBehind_; }

 private:
  /// The bytes of a compressed frame.
  std::vector<std::uint8_t> codestream(int number);
  void readNative(std::uint64_t frame, std::span<std::byte> words);

  const DicomFile& file_;
  NativePixels native_;
  std::optional<Fragments> fragments_;
  std::unique_ptr<std::byte[]> words_;
  std::size_t samplesOutside_ = 0, bytesBehind_ = 0;
};

}  // namespace fenestra::io
