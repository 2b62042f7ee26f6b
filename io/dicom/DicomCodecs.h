#pragma once
// Compressed frames to words: JPEG and JPEG-LS by DCMTK, JPEG 2000 by OpenJPEG, RLE here. The size and depth that a
// codestream has must be those of the header, and a warning of a library counts as damage: the libraries fill up what
// they could not decode, and a picture with such pixels must not pass for a whole one.

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Why a codestream cannot be decoded, in a few words.
class CodecError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Compression : std::uint8_t { Rle, Jpeg, JpegLs, Jpeg2000, Unknown };
/// `transferSyntax` is one of DCMTK's E_TransferSyntax.
Compression compressionOf(int transferSyntax);

/// Whether decoded samples are those that were compressed.
bool isLossless(int transferSyntax);

/// Decodes one frame into `words`, rows · columns words of bitsAllocated bits in this machine's byte order. Throws
/// CodecError.
void decodeFrame(std::vector<std::uint8_t> codestream, int transferSyntax, const PixelFormat& format,
                 std::span<std::byte> words);

}  // namespace fenestra::io
