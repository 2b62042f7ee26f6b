#pragma once
// Where the pixels of a DICOM file are, and their bytes frame by frame. The elements are walked here (PS3.5 chapter 7)
// so that nothing but the wanted frame is read: lengths in damaged files may promise gigabytes.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "io/base/ByteStream.h"

namespace fenestra::io {

/// The value of a file's pixel data element.
struct PixelPlace {
  std::uint64_t offset = 0;   ///< of its first byte: in the file, or in the unpacked dataset of a deflated one
  std::uint64_t length = 0;   ///< bytes, as the element says; 0 when encapsulated
  bool encapsulated = false;  ///< compressed frames, in fragments
  bool deflated = false;
  bool isPrivate = false;  ///< one compressed frame in a private element of Elscint
  int floatBytes = 0;      ///< of a sample of Float (4) or Double Float (8) Pixel Data; 0: integers
  int swapped = 1;         ///< bytes of the units that are stored the other way round (big endian): 1 is none
};

/// The private element that holds the pixels of some CTs by Elscint and Philips: (07a1,xx0a), its compression
/// (07a1,xx11).
inline constexpr std::uint16_t privatePixelGroup = 0x07a1, privatePixelElement = 0x0a;
inline constexpr const char* privatePixelCreator = "ELSCINT1";

/// How a file's elements are written.
struct ElementCoding {
  bool explicitVr = true, bigEndian = false;
};

/// The file from its start, or a deflated dataset unpacked from its own start. Throws Error.
struct DatasetStream {
  std::unique_ptr<ByteStream> bytes;
  bool deflated = false;
};
DatasetStream openDataset(const std::filesystem::path& path);

/// Finds Pixel Data, Float Pixel Data or Double Float Pixel Data on the top level, or else Elscint's element. Throws
/// Error when the file cannot be read.
std::optional<PixelPlace> findPixels(const std::filesystem::path& path, ElementCoding coding);

/// Bytes of uncompressed frames, in little-endian order. Reads forwards without opening the file again.
class NativePixels {
 public:
  NativePixels(std::filesystem::path path, const PixelPlace& place) : path_(std::move(path)), place_(place) {}
  /// The bytes from `start` of the pixel data. Throws Error when the file ends before.
  void read(std::uint64_t start, std::span<std::byte> into);

 private:
  std::filesystem::path path_;
  PixelPlace place_;
  std::unique_ptr<ByteStream> stream_;
  std::uint64_t at_ = 0;  ///< of the stream, in the pixel data
};

/// Fragments of compressed frames (PS3.5 A.4). Nothing but their places is kept.
class Fragments {
 public:
  /// Divides the fragments among `frames` frames. A missing end-of-sequence item is accepted at the file's end. Throws
  /// Error when a fragment reaches beyond the file or the fragments do not divide.
  Fragments(std::filesystem::path path, const PixelPlace& place, std::size_t frames);
  /// All bytes of a frame's fragments. Throws Error.
  std::vector<std::uint8_t> frame(std::size_t number) const;

 private:
  struct Piece {
    std::uint64_t offset = 0, length = 0;  ///< in the file, without the item's tag and length
  };
  void listPieces(const PixelPlace& place);
  void divide(std::size_t frames);
  std::vector<std::uint8_t> bytesOf(const Piece& piece, std::size_t most) const;

  std::filesystem::path path_;
  Piece offsetTable_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> first_;  ///< piece of each frame, and the end
};

}  // namespace fenestra::io
