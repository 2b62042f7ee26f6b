#include "io/dicom/ByteCodecs.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "io/dicom/CodecError.h"

namespace fenestra::io {
namespace {

std::uint64_t littleEndian32(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::uint64_t{bytes[at]} | std::uint64_t{bytes[at + 1]} << 8 | std::uint64_t{bytes[at + 2]} << 16 |
         std::uint64_t{bytes[at + 3]} << 24;
}

}  // namespace

std::size_t decodeRle(std::span<const std::uint8_t> bytes, const PixelFormat& format, std::span<std::byte> words) {
  constexpr std::size_t headerBytes = 64;
  const std::size_t wordBytes = static_cast<std::size_t>(format.bitsAllocated / 8), count = words.size() / wordBytes;
  if (bytes.size() < headerBytes) throw CodecError("its RLE header is cut off");
  if (littleEndian32(bytes, 0) != wordBytes)
    throw CodecError("it has " + std::to_string(littleEndian32(bytes, 0)) + " segments where pixels of " +
                     std::to_string(format.bitsAllocated) + " bits have " + std::to_string(wordBytes));
  for (std::size_t segment = 0; segment < wordBytes; ++segment) {
    std::size_t at = littleEndian32(bytes, 4 + 4 * segment);
    const std::size_t end = segment + 1 < wordBytes ? littleEndian32(bytes, 8 + 4 * segment) : bytes.size();
    if (at < headerBytes || at > end || end > bytes.size()) throw CodecError("its RLE header is damaged");
    const std::size_t place = std::endian::native == std::endian::little ? wordBytes - 1 - segment : segment;
    std::size_t filled = 0;
    while (filled < count && at < end) {
      const std::size_t control = bytes[at++];
      if (control == 128) continue;  // no operation
      const bool literal = control < 128;
      const std::size_t length = std::min(literal ? control + 1 : 257 - control, count - filled);
      if (at + (literal ? length : 1) > end) break;
      for (std::size_t i = 0; i < length; ++i)
        words[(filled + i) * wordBytes + place] = static_cast<std::byte>(bytes[literal ? at + i : at]);
      filled += length;
      at += literal ? length : 1;
    }
    if (filled < count) throw CodecError("an RLE segment ends too early");
    // Padding is zero. Between segments anything else means that a damaged run took the place of others; behind the
    // last one some writers leave what was in their buffer.
    const auto rest = bytes.subspan(at, end - at);
    const bool padding = std::all_of(rest.begin(), rest.end(), [](std::uint8_t byte) { return byte == 0; });
    if (!padding && segment + 1 == wordBytes) return rest.size();
    if (!padding) throw CodecError("an RLE segment is longer than its picture");
  }
  return 0;
}

void decodeEncapsulated(std::span<const std::uint8_t> bytes, const PixelFormat& format, std::span<std::byte> words) {
  if (bytes.size() < words.size())
    throw CodecError("it has " + std::to_string(bytes.size()) + " bytes where its picture needs " +
                     std::to_string(words.size()));
  std::memcpy(words.data(), bytes.data(), words.size());
  if constexpr (std::endian::native == std::endian::big) {
    const auto wordBytes = static_cast<std::ptrdiff_t>(format.bitsAllocated / 8);
    for (auto word = words.begin(); word != words.end(); word += wordBytes) std::reverse(word, word + wordBytes);
  }
}

void decodeElscint(std::span<const std::uint8_t> bytes, const PixelFormat& format, std::span<std::byte> words) {
  if (format.bitsAllocated != 16) throw CodecError("PMSCT_RLE1 of other than 16 bits a pixel");
  if (bytes.size() == words.size()) return decodeEncapsulated(bytes, format, words);
  constexpr std::uint8_t run = 0xa5, whole = 0x5a;
  std::vector<std::uint8_t> plain;
  const std::size_t most = words.size() / 2 * 3 + 1;  // three bytes a word, and the padding
  for (std::size_t at = 0; at < bytes.size() && plain.size() < most;) {
    if (bytes[at] != run) {
      plain.push_back(bytes[at++]);
      continue;
    }
    if (at + 2 >= bytes.size()) break;
    plain.insert(plain.end(), std::size_t{bytes[at + 1]} + 1, bytes[at + 2]);
    at += 3;
  }
  std::size_t at = 0;
  std::uint16_t value = 0;
  for (std::size_t i = 0; i < words.size() / 2; ++i) {
    const std::size_t bytesOfWord = at < plain.size() && plain[at] == whole ? 3 : 1;
    if (at + bytesOfWord > plain.size()) throw CodecError("its pixels end too early");
    if (bytesOfWord == 3)
      value = static_cast<std::uint16_t>(plain[at + 1] | plain[at + 2] << 8);
    else
      value = static_cast<std::uint16_t>(value + static_cast<std::int8_t>(plain[at]));
    std::memcpy(words.data() + i * sizeof value, &value, sizeof value);
    at += bytesOfWord;
  }
}

}  // namespace fenestra::io
