#pragma once
// Stored frames of one DICOM file as words: native, deflated, JPEG and JPEG-LS by DCMTK, JPEG 2000 by OpenJPEG, RLE
// here.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "io/dicom/DicomHeader.h"

namespace fenestra::io {

/// One file held open; use one decoder from one thread.
class DicomDecoder {
 public:
  /// Throws Error when the file cannot be read.
  explicit DicomDecoder(const DicomFile& file);
  ~DicomDecoder();

  /// The words of stored frame `number` in this machine's byte order, rows · columns of bitsAllocated bits, unused bits
  /// as stored; valid until the next call. Throws Error.
  std::span<const std::byte> decode(int number);

 private:
  struct State;
  const DicomFile& file_;
  std::unique_ptr<State> state_;
  std::unique_ptr<std::byte[]> words_;
};

}  // namespace fenestra::io
