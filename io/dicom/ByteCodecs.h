#pragma once
// Encodings of frames that are simple enough for code of our own. Each fills `words`, rows · columns words of
// bitsAllocated bits in this machine's byte order, and throws CodecError.

#include <cstddef>
#include <cstdint>
#include <span>

#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// RLE Lossless (PS3.5 Annex G): one PackBits segment for each byte of a word, the most significant first. Returns the
/// bytes behind the last run that are no padding. DCMTK's decoder is not used because it reads outside damaged
/// segments.
std::size_t decodeRle(std::span<const std::uint8_t> bytes, const PixelFormat& format, std::span<std::byte> words);
/// Frames that are encapsulated without compression (PS3.5 A.4.11): little-endian words, padded to an even length.
void decodeEncapsulated(std::span<const std::uint8_t> bytes, const PixelFormat& format, std::span<std::byte> words);
/// PMSCT_RLE1 of Elscint and Philips (as GDCM's and dcm2niix' authors found it out): runs A5 COUNT-1 VALUE of bytes,
/// which hold a word each as its difference from the one before, in a signed byte, or as 5A LOW HIGH. Pixels that are
/// as long as the picture are not compressed.
void decodeElscint(std::span<const std::uint8_t> bytes, const PixelFormat& format, std::span<std::byte> words);

}  // namespace fenestra::io
