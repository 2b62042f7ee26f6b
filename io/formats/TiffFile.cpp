#include "io/formats/TiffFile.h"

#include <tiffio.h>

#include <algorithm>
#include <bit>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <utility>

#include "io/base/Memory.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t mostPages = 1'000'000;

/// A file that is open, and the first complaint of libtiff about it.
class TiffFile {
 public:
  explicit TiffFile(fs::path path) : path_(std::move(path)) {
    std::error_code failure;
    const auto held = static_cast<std::int64_t>(fs::file_size(path_, failure));
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree);
    // Tables and strips that a damaged file makes larger than all that it holds.
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), std::max(std::int64_t{256} << 20, 4 * held));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keepMessage, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), dropMessage, nullptr);
    // m: not mapped into memory, where a file that shrinks would end the program.
    file_.reset(TIFFOpenExt(path_.c_str(), "rm", options.get()));
    if (!file_) fail("is no TIFF file that can be read");
  }
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  TIFF* get() const { return file_.get(); }
  const fs::path& path() const { return path_; }
  [[noreturn]] void fail(const std::string& cause) const {
    refuseDamaged(path_, message_.empty() ? cause : cause + ": " + message_);
  }
  bool hasComplained() const { return !message_.empty(); }
  template <class T>
  T tag(std::uint32_t number, T otherwise) const {
    T value{};
    return TIFFGetFieldDefaulted(get(), number, &value) == 1 ? value : otherwise;
  }

 private:
  static int keepMessage(TIFF*, void* self, const char*, const char* format, va_list arguments) {
    char text[200];
    std::vsnprintf(text, sizeof text, format, arguments);
    auto& message = static_cast<TiffFile*>(self)->message_;
    if (message.empty())
      for (const char* c = text; *c != '\0'; ++c) message += *c >= ' ' && *c <= '~' ? *c : ' ';
    return 1;
  }
  static int dropMessage(TIFF*, void*, const char*, const char*, va_list) { return 1; }

  fs::path path_;
  std::string message_;
  std::unique_ptr<TIFF, void (*)(TIFF*)> file_{nullptr, TIFFClose};
};

[[noreturn]] void refuse(const TiffFile& file, const std::string& cause) {
  throw Error(file.path(), cause, "save it as grey values of 8, 16 or 32 bits");
}

ElementType typeOf(const TiffFile& file) {
  const int bits = file.tag<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 1);
  const int format = file.tag<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  if (format == SAMPLEFORMAT_IEEEFP && bits == 32) return ElementType::Float32;
  if (format == SAMPLEFORMAT_IEEEFP && bits == 64) return ElementType::Float64;
  const bool isSigned = format == SAMPLEFORMAT_INT;
  if (isSigned || format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID) switch (bits) {
      case 8:
        return isSigned ? ElementType::Int8 : ElementType::UInt8;
      case 16:
        return isSigned ? ElementType::Int16 : ElementType::UInt16;
      case 32:
        return isSigned ? ElementType::Int32 : ElementType::UInt32;
      case 64:
        return isSigned ? ElementType::Int64 : ElementType::UInt64;
      default:
        break;
    }
  refuse(file, "has pixels of " + std::to_string(bits) + " bits in TIFF's sample format " + std::to_string(format));
}

TiffPage pageIn(const TiffFile& file) {
  TiffPage page;
  page.place = TIFFCurrentDirOffset(file.get());
  page.width = file.tag<std::uint32_t>(TIFFTAG_IMAGEWIDTH, 0);
  page.height = file.tag<std::uint32_t>(TIFFTAG_IMAGELENGTH, 0);
  if (page.width == 0 || page.height == 0) file.fail("has a page of no size");
  const int samples = file.tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 1);
  const int photometric = file.tag<std::uint16_t>(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (samples != 1) refuse(file, "holds colours: " + std::to_string(samples) + " values at each pixel");
  page.type = typeOf(file);
  // Floats and signed integers have no greatest value that is black: they are never inverted.
  const bool isUnsigned = page.type == ElementType::UInt8 || page.type == ElementType::UInt16 ||
                          page.type == ElementType::UInt32 || page.type == ElementType::UInt64;
  page.whiteIsZero = photometric == PHOTOMETRIC_MINISWHITE && isUnsigned;
  page.hasPalette = photometric == PHOTOMETRIC_PALETTE;
  if (photometric != PHOTOMETRIC_MINISWHITE && !page.hasPalette && photometric != PHOTOMETRIC_MINISBLACK)
    refuse(file, "holds colours (TIFF's photometric interpretation " + std::to_string(photometric) + ")");
  const int compression = file.tag<std::uint16_t>(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  page.isCompressed = compression != COMPRESSION_NONE;
  if (page.isCompressed && TIFFIsCODECConfigured(static_cast<std::uint16_t>(compression)) == 0)
    throw Error(file.path(),
                "is compressed in a way that cannot be read (TIFF's number " + std::to_string(compression) + ")",
                "save it uncompressed, or with LZW or deflate");
  page.firstStrip = TIFFGetStrileOffset(file.get(), 0);
  page.xResolution = file.tag<float>(TIFFTAG_XRESOLUTION, 0.0f);
  page.yResolution = file.tag<float>(TIFFTAG_YRESOLUTION, 0.0f);
  page.resolutionUnit = file.tag<std::uint16_t>(TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  page.orientation = file.tag<std::uint16_t>(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  return page;
}

/// Decodes the current page into `into`, which has room for it.
class PageDecoder {
 public:
  PageDecoder(const TiffFile& file, const TiffPage& page, std::vector<std::byte>& into)
      : file_(file), page_(page), into_(into), rowBytes_(std::size_t{page.width} * sizeOf(page.type)) {}

  void decode() {
    if (TIFFIsTiled(file_.get()) != 0)
      decodeTiles();
    else
      decodeStrips();
  }

 private:
  /// A block of rows or a tile; `size` comes from the file.
  std::vector<std::byte>& buffer(tmsize_t size) {
    // A tile may reach beyond the page, but no writer makes it many times larger.
    constexpr std::size_t most = 64u << 20;
    if (size <= 0 || static_cast<std::size_t>(size) > std::max(most, 4 * into_.size()))
      file_.fail("has a page in blocks of an impossible size");
    buffer_.resize(static_cast<std::size_t>(size));
    return buffer_;
  }

  void decodeStrips() {
    const std::uint32_t strips = TIFFNumberOfStrips(file_.get());
    std::size_t filled = 0;
    std::vector<std::byte>& block = buffer(TIFFStripSize(file_.get()));
    for (std::uint32_t strip = 0; strip < strips && filled < into_.size(); ++strip) {
      const tmsize_t got = TIFFReadEncodedStrip(file_.get(), strip, block.data(), static_cast<tmsize_t>(block.size()));
      if (got <= 0) file_.fail("has a page that does not decode");
      const std::size_t taken = std::min(static_cast<std::size_t>(got), into_.size() - filled);
      std::memcpy(into_.data() + filled, block.data(), taken);
      filled += taken;
    }
    if (filled != into_.size() || file_.hasComplained()) file_.fail("has a page that does not decode");
  }

  void decodeTiles() {
    const auto width = file_.tag<std::uint32_t>(TIFFTAG_TILEWIDTH, 0),
               height = file_.tag<std::uint32_t>(TIFFTAG_TILELENGTH, 0);
    std::vector<std::byte>& tile = buffer(TIFFTileSize(file_.get()));
    const std::size_t scalar = sizeOf(page_.type), tileRow = std::size_t{width} * scalar;
    if (width == 0 || height == 0 || tile.size() < tileRow * height) file_.fail("has tiles of no size");
    for (std::uint64_t y = 0; y < page_.height; y += height)
      for (std::uint64_t x = 0; x < page_.width; x += width) {
        const std::uint32_t number =
            TIFFComputeTile(file_.get(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0);
        if (TIFFReadEncodedTile(file_.get(), number, tile.data(), static_cast<tmsize_t>(tile.size())) <= 0)
          file_.fail("has a page that does not decode");
        const std::size_t columns = std::min<std::uint64_t>(width, page_.width - x) * scalar;
        for (std::uint64_t row = 0; row < std::min<std::uint64_t>(height, page_.height - y); ++row)
          std::memcpy(into_.data() + (y + row) * rowBytes_ + x * scalar, tile.data() + row * tileRow, columns);
      }
    if (file_.hasComplained()) file_.fail("has a page that does not decode");
  }

  const TiffFile& file_;
  const TiffPage& page_;
  std::vector<std::byte>& into_;
  std::size_t rowBytes_;
  std::vector<std::byte> buffer_;
};

class PageStream : public ByteStream {
 public:
  PageStream(std::vector<TiffPageOf> pages, std::uint64_t begin) : pages_(std::move(pages)) {
    const std::uint64_t each = pages_.front().page.bytes();
    next_ = static_cast<std::size_t>(begin / each);
    if (next_ >= pages_.size()) return;
    decode();
    at_ = static_cast<std::size_t>(begin % each);
  }

  std::size_t read(std::byte* into, std::size_t size) override {
    std::size_t got = 0;
    while (got < size) {
      if (at_ == page_.size()) {
        if (next_ >= pages_.size()) break;
        decode();
      }
      const std::size_t taken = std::min(size - got, page_.size() - at_);
      std::memcpy(into + got, page_.data() + at_, taken);
      got += taken;
      at_ += taken;
    }
    return got;
  }

 private:
  void decode() {
    const TiffPageOf& wanted = pages_[next_++];
    if (!file_ || file_->path() != wanted.file) file_ = std::make_unique<TiffFile>(wanted.file);
    if (TIFFSetSubDirectory(file_->get(), wanted.page.place) == 0) file_->fail("has lost a page");
    page_.assign(static_cast<std::size_t>(wanted.page.bytes()), std::byte{0});
    PageDecoder(*file_, wanted.page, page_).decode();
    if (wanted.page.whiteIsZero)
      for (std::byte& byte : page_) byte = ~byte;
    at_ = 0;
  }

  std::vector<TiffPageOf> pages_;
  std::size_t next_ = 0, at_ = 0;
  std::unique_ptr<TiffFile> file_;
  std::vector<std::byte> page_;
};

}  // namespace

TiffDirectory readTiffPages(const fs::path& path) {
  const TiffFile file(path);
  TiffDirectory directory;
  directory.bigEndian = TIFFIsBigEndian(file.get()) != 0;
  do {
    // Thumbnails and masks of other pages.
    constexpr std::uint32_t auxiliary = FILETYPE_REDUCEDIMAGE | FILETYPE_MASK;
    if ((file.tag<std::uint32_t>(TIFFTAG_SUBFILETYPE, 0) & auxiliary) != 0) continue;
    if (directory.pages.empty())
      if (const char* text = nullptr; TIFFGetField(file.get(), TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text)
        directory.description = text;
    directory.pages.push_back(pageIn(file));
    if (directory.pages.size() > mostPages) file.fail("has over a million pages");
  } while (TIFFReadDirectory(file.get()) != 0);
  if (file.hasComplained()) file.fail("has a page that cannot be read");
  if (directory.pages.empty()) file.fail("holds no page");
  return directory;
}

std::unique_ptr<ByteStream> openTiffPages(std::vector<TiffPageOf> pages, std::uint64_t begin) {
  return std::make_unique<PageStream>(std::move(pages), begin);
}

}  // namespace fenestra::io
