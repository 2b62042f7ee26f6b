#pragma once
// Compressed frames to words: JPEG and JPEG-LS by DCMTK, JPEG 2000 and its high-throughput form by OpenJPEG, others by
// ByteCodecs.h. The size and depth that a codestream has must be those of the header, and a warning of a library counts
// as damage: the libraries fill up what they could not decode, and a picture with such pixels must not pass for a whole
// one.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// What was odd about a frame that decoded.
struct DecodedFrame {
  std::size_t bytesBehind = 0;  ///< behind the last run of an RLE frame, other than padding
};
/// Decodes one frame of `file` into `words`, rows · columns words of bitsAllocated bits in this machine's byte order.
/// Throws CodecError.
DecodedFrame decodeFrame(std::vector<std::uint8_t> codestream, const DicomFile& file, std::span<std::byte> words);

}  // namespace fenestra::io
