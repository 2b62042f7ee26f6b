#include "io/dicom/DicomPixels.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "io/base/Error.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::uint32_t undefinedLength = 0xffffffff;
constexpr std::uint32_t itemTag = 0xfffee000, itemEnd = 0xfffee00d, sequenceEnd = 0xfffee0dd;
constexpr std::uint32_t floatPixels = 0x7fe00008, doublePixels = 0x7fe00009, integerPixels = 0x7fe00010;
constexpr const char* damagedHint = "the file is truncated or damaged";
constexpr const char* deflatedUid = "1.2.840.10008.1.2.1.99";  // Deflated Explicit VR Little Endian

/// Numbers and skips in a stream, buffered.
class Cursor {
 public:
  explicit Cursor(ByteStream& stream) : stream_(stream), buffer_(64 * 1024) {}

  std::uint64_t position() const { return start_ + at_; }
  /// False at the end of the stream.
  bool read(std::span<unsigned char> into) {
    for (unsigned char& byte : into) {
      if (at_ == filled_ && !refill()) return false;
      byte = static_cast<unsigned char>(buffer_[at_++]);
    }
    return true;
  }
  bool skip(std::uint64_t count) {
    while (count > 0) {
      if (at_ == filled_ && !refill()) return false;
      const auto step = static_cast<std::size_t>(std::min<std::uint64_t>(count, filled_ - at_));
      at_ += step;
      count -= step;
    }
    return true;
  }

 private:
  bool refill() {
    start_ += filled_;
    at_ = 0;
    filled_ = stream_.read(buffer_.data(), buffer_.size());
    return filled_ > 0;
  }

  ByteStream& stream_;
  std::vector<std::byte> buffer_;
  std::uint64_t start_ = 0;  ///< of the buffer in the stream
  std::size_t at_ = 0, filled_ = 0;
};

std::uint32_t number(std::span<const unsigned char> bytes, bool bigEndian) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    value |= std::uint32_t{bytes[i]} << 8 * (bigEndian ? bytes.size() - 1 - i : i);
  return value;
}

struct Element {
  std::uint32_t tag = 0, length = 0;
  std::string vr;  ///< empty in implicit coding and of items
};

/// Whether explicit coding gives the length of a value in four bytes (PS3.5 table 7.1-1). Unknown VRs are taken to be
/// later additions to the standard, which all do.
bool hasLongLength(std::string_view vr) {
  constexpr std::array<std::string_view, 21> shortOnes = {"AE", "AS", "AT", "CS", "DA", "DS", "DT",
                                                          "FD", "FL", "IS", "LO", "LT", "PN", "SH",
                                                          "SL", "SS", "ST", "TM", "UI", "UL", "US"};
  const auto isLetter = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (!isLetter(vr[0]) || !isLetter(vr[1])) return false;
  return std::find(shortOnes.begin(), shortOnes.end(), vr) == shortOnes.end();
}

/// The next element's tag and length; empty at the end of the stream.
std::optional<Element> nextElement(Cursor& cursor, ElementCoding coding) {
  std::array<unsigned char, 8> head{};
  if (!cursor.read(head)) return std::nullopt;
  const std::span<const unsigned char> bytes(head);
  Element element;
  element.tag = number(bytes.subspan(0, 2), coding.bigEndian) << 16 | number(bytes.subspan(2, 2), coding.bigEndian);
  if (!coding.explicitVr || element.tag >> 16 == 0xfffe) {
    element.length = number(bytes.subspan(4), coding.bigEndian);
    return element;
  }
  element.vr.assign(reinterpret_cast<const char*>(head.data()) + 4, 2);
  if (!hasLongLength(element.vr)) {
    element.length = number(bytes.subspan(6), coding.bigEndian);
    return element;
  }
  std::array<unsigned char, 4> length{};
  if (!cursor.read(length)) return std::nullopt;
  element.length = number(length, coding.bigEndian);
  return element;
}

/// Bytes of the units that a big-endian file turns round in values of this VR.
int swappedUnit(const Element& element) {
  if (element.tag == floatPixels) return 4;
  if (element.tag == doublePixels) return 8;
  return element.vr == "OB" || element.vr == "UN" ? 1 : 2;
}

}  // namespace

DatasetStream openDataset(const fs::path& path) {
  // Preamble, "DICM" and the group length element, whose value is the length of the rest of the meta header (PS3.10
  // 7.1).
  constexpr std::size_t metaStart = 144;
  std::array<char, 1024> head{};
  const auto stream = openStream(path, 0, Packing::None);
  const std::size_t got = stream->read(reinterpret_cast<std::byte*>(head.data()), head.size());
  const std::string_view text(head.data(), got);
  if (text.find(deflatedUid) == std::string_view::npos || got < metaStart)
    return {openStream(path, 0, Packing::None), false};
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < 4; ++i)
    length |= std::uint32_t{static_cast<unsigned char>(head[metaStart - 4 + i])} << (8 * i);
  return {openStream(path, metaStart + length, Packing::RawDeflate), true};
}

std::optional<PixelPlace> findPixels(const fs::path& path, ElementCoding coding) {
  constexpr std::size_t preamble = 128;
  const DatasetStream dataset = openDataset(path);
  Cursor cursor(*dataset.bytes);
  bool inMeta = !dataset.deflated;
  if (inMeta) {
    std::array<char, preamble + 4> head{};
    const auto stream = openStream(path, 0, Packing::None);
    const std::size_t got = stream->read(reinterpret_cast<std::byte*>(head.data()), head.size());
    if (got == head.size() && std::string_view(head.data() + preamble, 4) == "DICM") cursor.skip(head.size());
    // Without a preamble, the meta header may be missing too.
    else
      inMeta = head[0] == 2 && head[1] == 0;
  }
  // The coding of each open level: elements of unknown type and undefined length are implicit inside (PS3.5 6.2.2).
  std::vector<ElementCoding> levels{coding};
  std::optional<PixelPlace> elscint;
  for (;;) {
    // The meta header is explicit and little-endian whatever the dataset is; its group length comes first.
    std::optional<Element> element = nextElement(cursor, inMeta ? ElementCoding{} : levels.back());
    if (!element) break;
    if (inMeta) {
      if (element->tag == 0x00020000) {
        std::array<unsigned char, 4> length{};
        if (!cursor.read(length) || !cursor.skip(number(length, false))) break;
        inMeta = false;
      } else if (element->tag >> 16 != 0x0002) {
        break;
      } else if (!cursor.skip(element->length)) {
        break;
      }
      continue;
    }
    const bool top = levels.size() == 1;
    if (top && (element->tag == integerPixels || element->tag == floatPixels || element->tag == doublePixels)) {
      PixelPlace place;
      place.offset = cursor.position();
      place.encapsulated = element->length == undefinedLength;
      place.length = place.encapsulated ? 0 : element->length;
      place.deflated = dataset.deflated;
      place.floatBytes = element->tag == floatPixels ? 4 : element->tag == doublePixels ? 8 : 0;
      if (coding.bigEndian) place.swapped = swappedUnit(*element);
      return place;
    }
    const bool isElscint = element->tag >> 16 == privatePixelGroup && (element->tag & 0xff) == privatePixelElement &&
                           (element->tag & 0xff00) >= 0x1000;
    if (top && isElscint && element->length != undefinedLength)
      elscint = PixelPlace{
          .offset = cursor.position(), .length = element->length, .deflated = dataset.deflated, .isPrivate = true};
    if (element->tag == itemEnd || element->tag == sequenceEnd) {
      if (!top) levels.pop_back();
    } else if (element->length == undefinedLength) {
      levels.push_back(element->vr == "UN" ? ElementCoding{false, false} : levels.back());
    } else if (!cursor.skip(element->length)) {
      break;
    }
  }
  return elscint;
}

void NativePixels::read(std::uint64_t start, std::span<std::byte> into) {
  // Whole units are read, because the bytes of each change places.
  const auto unit = static_cast<std::uint64_t>(place_.swapped);
  const std::uint64_t from = start / unit * unit;
  const std::uint64_t to = (start + into.size() + unit - 1) / unit * unit;
  if (!stream_ || at_ > from || (at_ < from && !place_.deflated)) {
    stream_ = place_.deflated ? openDataset(path_).bytes : openStream(path_, place_.offset + from, Packing::None);
    at_ = from;
    if (place_.deflated) stream_->skip(place_.offset + from);
  }
  if (at_ < from) stream_->skip(from - at_);
  if (unit == 1) {
    stream_->readAll(into.data(), into.size(), path_);
  } else {
    std::vector<std::byte> bytes(static_cast<std::size_t>(to - from));
    stream_->readAll(bytes.data(), bytes.size(), path_);
    for (std::size_t i = 0; i < bytes.size(); i += unit)
      std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                   bytes.begin() + static_cast<std::ptrdiff_t>(i + unit));
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(start - from), into.size(), into.begin());
  }
  at_ = to;
}

Fragments::Fragments(fs::path path, const PixelPlace& place, std::size_t frames) : path_(std::move(path)) {
  listPieces(place);
  divide(frames);
}

void Fragments::listPieces(const PixelPlace& place) {
  std::error_code failure;
  const std::uint64_t size = fs::file_size(path_, failure);
  std::vector<Piece> pieces;
  std::ifstream file(path_, std::ios::binary);
  for (std::uint64_t at = place.offset; at < size;) {
    std::array<unsigned char, 8> head{};
    file.seekg(static_cast<std::streamoff>(at));
    if (!file.read(reinterpret_cast<char*>(head.data()), head.size())) break;
    const std::span<const unsigned char> bytes(head);
    const std::uint32_t tag = number(bytes.subspan(0, 2), false) << 16 | number(bytes.subspan(2, 2), false);
    const std::uint32_t length = number(bytes.subspan(4), false);
    if (tag == sequenceEnd) break;
    if (tag != itemTag)
      throw Error(path_, "its compressed pixels cannot be read (no fragment where one belongs)", damagedHint);
    if (length > size - at - head.size())
      throw Error(path_,
                  "its compressed pixels cannot be read (a fragment of " + std::to_string(length) +
                      " bytes, of which the file holds " + std::to_string(size - at - head.size()) + ")",
                  damagedHint);
    pieces.push_back({at + head.size(), length});
    at += head.size() + length;
  }
  if (pieces.size() < 2) throw Error(path_, "its compressed pixels cannot be read (there are none)", damagedHint);
  offsetTable_ = pieces.front();
  pieces_.assign(pieces.begin() + 1, pieces.end());
}

/// Most files have one fragment a frame. In others the offset table gives the first fragments, or the start-of-image
/// markers of JPEG (FF D8) and JPEG 2000 (FF 4F) show them.
void Fragments::divide(std::size_t frames) {
  if (pieces_.size() == frames) {
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) first_.push_back(piece);
  } else if (frames == 1) {
    first_.push_back(0);
  } else if (pieces_.size() > frames && offsetTable_.length == frames * 4) {
    const std::vector<std::uint8_t> table = bytesOf(offsetTable_, offsetTable_.length);
    const std::uint64_t start = pieces_.front().offset;
    for (std::size_t piece = 0; piece < pieces_.size() && first_.size() < frames; ++piece)
      if (pieces_[piece].offset - start ==
          number(std::span<const unsigned char>(table).subspan(4 * first_.size(), 4), false))
        first_.push_back(piece);
  }
  if (first_.size() != frames) {
    first_.clear();
    for (std::size_t piece = 0; pieces_.size() > frames && piece < pieces_.size(); ++piece) {
      const std::vector<std::uint8_t> start = bytesOf(pieces_[piece], 3);
      if (start.size() == 3 && start[0] == 0xff && (start[1] == 0xd8 || start[1] == 0x4f) && start[2] == 0xff)
        first_.push_back(piece);
    }
  }
  if (first_.size() != frames)
    throw Error(path_,
                "its compressed pixels cannot be read (" + std::to_string(pieces_.size()) +
                    " fragments do not divide into " + std::to_string(frames) + " frames)",
                damagedHint);
  first_.push_back(pieces_.size());
}

std::vector<std::uint8_t> Fragments::bytesOf(const Piece& piece, std::size_t most) const {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min<std::uint64_t>(piece.length, most)));
  openStream(path_, piece.offset, Packing::None)
      ->readAll(reinterpret_cast<std::byte*>(bytes.data()), bytes.size(), path_);
  return bytes;
}

std::vector<std::uint8_t> Fragments::frame(std::size_t number) const {
  std::vector<std::uint8_t> bytes;
  for (std::size_t piece = first_[number]; piece < first_[number + 1]; ++piece) {
    const std::vector<std::uint8_t> part = bytesOf(pieces_[piece], std::numeric_limits<std::size_t>::max());
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  return bytes;
}

}  // namespace fenestra::io
