#include "io/base/ByteStream.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include <bzlib.h>
#include <zlib.h>

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t chunkBytes = 256 * 1024;

class FileStream : public ByteStream {
 public:
  FileStream(fs::path path, std::uint64_t offset) : path_(std::move(path)), file_(std::fopen(path_.c_str(), "rb")) {
    if (!file_) throw Error(path_, "cannot be opened: " + systemCause(), "check the path and its permissions");
    // Reads are large already; the C library's own buffer would only copy once more.
    std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    if (offset > static_cast<std::uint64_t>(std::numeric_limits<off_t>::max()) ||
        ::fseeko(file_.get(), static_cast<off_t>(offset), SEEK_SET) != 0)
      throw Error(path_, "has no byte " + std::to_string(offset), "the file is damaged or its header is wrong");
  }
  std::size_t read(std::byte* into, std::size_t size) override {
    const std::size_t got = std::fread(into, 1, size, file_.get());
    if (got < size && std::ferror(file_.get()))
      throw Error(path_, "cannot be read: " + systemCause(), "check the disk and the file's permissions");
    return got;
  }
  const fs::path& path() const { return path_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  fs::path path_;
  std::unique_ptr<std::FILE, Close> file_;
};

[[noreturn]] void throwTruncated(const fs::path& path) {
  throw Error(path, "ends too early", "the file is truncated; get it again from its source");
}

[[noreturn]] void throwDamaged(const fs::path& path) {
  throw Error(path, "its compressed data are damaged", "get the file again from its source");
}

class DeflateStream : public ByteStream {
 public:
  DeflateStream(FileStream source, bool raw) : source_(std::move(source)), packed_(chunkBytes) {
    // 15 is the largest window; + 32 tells zlib from gzip by the header, negative stands for no header.
    if (inflateInit2(&state_, raw ? -15 : 15 + 32) != Z_OK) throw std::bad_alloc();
  }
  ~DeflateStream() override { inflateEnd(&state_); }
  DeflateStream(const DeflateStream&) = delete;
  DeflateStream& operator=(const DeflateStream&) = delete;

  std::size_t read(std::byte* into, std::size_t size) override {
    std::size_t got = 0;
    while (got < size) {
      if (state_.avail_in == 0) {
        state_.avail_in = static_cast<uInt>(source_.read(packed_.data(), packed_.size()));
        state_.next_in = reinterpret_cast<Bytef*>(packed_.data());
        if (state_.avail_in == 0) {
          if (!ended_) throwTruncated(source_.path());
          return got;
        }
      }
      if (ended_) {
        // gzip files may be several streams one after the other; anything else behind the end is padding.
        if (*state_.next_in != 0x1f || inflateReset(&state_) != Z_OK) return got;
        ended_ = false;
      }
      const std::size_t room = std::min<std::size_t>(size - got, std::numeric_limits<uInt>::max());
      state_.next_out = reinterpret_cast<Bytef*>(into + got);
      state_.avail_out = static_cast<uInt>(room);
      const int result = inflate(&state_, Z_NO_FLUSH);
      got += room - state_.avail_out;
      if (result == Z_STREAM_END)
        ended_ = true;
      else if (result != Z_OK && result != Z_BUF_ERROR)
        throwDamaged(source_.path());
    }
    return got;
  }

 private:
  FileStream source_;
  std::vector<std::byte> packed_;
  z_stream state_{};
  bool ended_ = false;
};

class Bzip2Stream : public ByteStream {
 public:
  explicit Bzip2Stream(FileStream source) : source_(std::move(source)), packed_(chunkBytes) {
    if (BZ2_bzDecompressInit(&state_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  ~Bzip2Stream() override { BZ2_bzDecompressEnd(&state_); }
  Bzip2Stream(const Bzip2Stream&) = delete;
  Bzip2Stream& operator=(const Bzip2Stream&) = delete;

  std::size_t read(std::byte* into, std::size_t size) override {
    std::size_t got = 0;
    while (got < size && !ended_) {
      if (state_.avail_in == 0) {
        state_.avail_in = static_cast<unsigned>(source_.read(packed_.data(), packed_.size()));
        state_.next_in = reinterpret_cast<char*>(packed_.data());
        if (state_.avail_in == 0) throwTruncated(source_.path());
      }
      const std::size_t room = std::min<std::size_t>(size - got, std::numeric_limits<unsigned>::max());
      state_.next_out = reinterpret_cast<char*>(into + got);
      state_.avail_out = static_cast<unsigned>(room);
      const int result = BZ2_bzDecompress(&state_);
      got += room - state_.avail_out;
      if (result == BZ_STREAM_END)
        ended_ = true;
      else if (result != BZ_OK)
        throwDamaged(source_.path());
    }
    return got;
  }

 private:
  FileStream source_;
  std::vector<std::byte> packed_;
  bz_stream state_{};
  bool ended_ = false;
};

}  // namespace

void ByteStream::readAll(std::byte* into, std::size_t size, const fs::path& file) {
  if (read(into, size) < size) throwTruncated(file);
}

void ByteStream::skip(std::uint64_t count) {
  std::vector<std::byte> dropped(static_cast<std::size_t>(std::min<std::uint64_t>(count, chunkBytes)));
  while (count > 0) {
    const std::size_t got =
        read(dropped.data(), static_cast<std::size_t>(std::min<std::uint64_t>(count, dropped.size())));
    if (got == 0) return;
    count -= got;
  }
}

std::unique_ptr<ByteStream> openStream(const fs::path& file, std::uint64_t offset, Packing packing) {
  FileStream source(file, offset);
  switch (packing) {
    case Packing::None:
      break;
    case Packing::Deflate:
    case Packing::RawDeflate:
      return std::make_unique<DeflateStream>(std::move(source), packing == Packing::RawDeflate);
    case Packing::Bzip2:
      return std::make_unique<Bzip2Stream>(std::move(source));
  }
  return std::make_unique<FileStream>(std::move(source));
}

bool isGzip(const fs::path& file) {
  std::array<std::byte, 2> magic{};
  return FileStream(file, 0).read(magic.data(), magic.size()) == magic.size() && startsAsGzip(magic);
}

bool startsAsGzip(std::span<const std::byte> bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

std::unique_ptr<ByteStream> openMaybeGzip(const fs::path& file) {
  return openStream(file, 0, isGzip(file) ? Packing::Deflate : Packing::None);
}

std::string systemCause() { return std::error_code(errno, std::generic_category()).message(); }

}  // namespace fenestra::io
