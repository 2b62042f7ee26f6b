#include "io/formats/VoxelText.h"

#include <charconv>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

class TextScalars : public ByteStream {
 public:
  TextScalars(std::unique_ptr<ByteStream> source, ElementType type, std::uint64_t count, fs::path path)
      : source_(std::move(source)), type_(type), left_(count), path_(std::move(path)) {}

  std::size_t read(std::byte* into, std::size_t size) override {
    const std::size_t scalar = sizeOf(type_);
    std::size_t got = 0;
    std::string word;
    while (got + scalar <= size && nextWord(word)) {
      visitElement(type_, [&](auto value) {
        const char* end = word.data() + word.size();
        const auto [stopped, failure] = std::from_chars(word.data(), end, value);
        if (failure != std::errc() || stopped != end)
          throw Error(path_, "holds '" + word.substr(0, 20) + "' where a number of its type belongs",
                      "the file is damaged or its type is wrong");
        std::memcpy(into + got, &value, sizeof value);
      });
      got += scalar;
      if (--left_ == 0) checkCommas();
    }
    return got;
  }

 private:
  /// Commas divide numbers; where they leave more than there should be, they may have been decimal commas.
  void checkCommas() {
    std::string word;
    if (!hadComma_ || !nextWord(word)) return;
    throw Error(path_, "holds more numbers than its header describes, and commas between them",
                "if these are decimal commas, write the numbers with points");
  }
  bool nextWord(std::string& word) {
    // Longer than any number a type can hold, and short enough to refuse binary data soon.
    constexpr std::size_t longestNumber = 400;
    word.clear();
    for (;;) {
      if (next_ == filled_) {
        filled_ = source_->read(buffer_.data(), buffer_.size());
        next_ = 0;
        if (filled_ == 0) return !word.empty();
      }
      const char c = static_cast<char>(buffer_[next_++]);
      const bool separator = c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',';
      hadComma_ |= c == ',';
      if (!separator) word += c;
      if ((separator && !word.empty()) || word.size() > longestNumber) return true;
    }
  }

  std::unique_ptr<ByteStream> source_;
  ElementType type_;
  std::uint64_t left_;
  bool hadComma_ = false;
  fs::path path_;
  std::vector<std::byte> buffer_ = std::vector<std::byte>(64 * 1024);
  std::size_t next_ = 0, filled_ = 0;
};

class HexBytes : public ByteStream {
 public:
  HexBytes(std::unique_ptr<ByteStream> source, fs::path path) : source_(std::move(source)), path_(std::move(path)) {}

  std::size_t read(std::byte* into, std::size_t size) override {
    std::size_t got = 0;
    for (; got < size; ++got) {
      const int high = nextDigit(), low = high < 0 ? -1 : nextDigit();
      if (low < 0) break;
      into[got] = static_cast<std::byte>(high * 16 + low);
    }
    return got;
  }

 private:
  /// -1 at the end.
  int nextDigit() {
    for (;;) {
      if (next_ == filled_) {
        filled_ = source_->read(buffer_.data(), buffer_.size());
        next_ = 0;
        if (filled_ == 0) return -1;
      }
      const char c = static_cast<char>(buffer_[next_++]);
      if (c >= '0' && c <= '9') return c - '0';
      if (c >= 'a' && c <= 'f') return c - 'a' + 10;
      if (c >= 'A' && c <= 'F') return c - 'A' + 10;
      if (c != ' ' && c != '\t' && c != '\n' && c != '\r')
        throw Error(path_, "holds characters that are no hexadecimal digits", "the file is damaged");
    }
  }

  std::unique_ptr<ByteStream> source_;
  fs::path path_;
  std::vector<std::byte> buffer_ = std::vector<std::byte>(64 * 1024);
  std::size_t next_ = 0, filled_ = 0;
};

}  // namespace

std::unique_ptr<ByteStream> decimalScalars(std::unique_ptr<ByteStream> source, ElementType type, std::uint64_t count,
                                           const fs::path& path) {
  return std::make_unique<TextScalars>(std::move(source), type, count, path);
}

std::unique_ptr<ByteStream> hexadecimalBytes(std::unique_ptr<ByteStream> source, const fs::path& path) {
  return std::make_unique<HexBytes>(std::move(source), path);
}

}  // namespace fenestra::io
