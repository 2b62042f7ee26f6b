#include "tests/layers/Sources.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fenestra::tests {
namespace {

namespace fs = std::filesystem;

const fs::path checkout = FENESTRA_SOURCE_DIR;

/// Blanks out what is not code, one construct at a time.
class Blanker {
 public:
  explicit Blanker(std::string_view text) : text_(text) {}

  std::string run() {
    while (at_ < text_.size()) {
      if (startsLine() && text_[firstNonBlank()] == '#')
        blankDirective();
      else if (follows("//"))
        blankUntil("\n", 0);
      else if (follows("/*"))
        blankUntil("*/", 2);
      else if (follows("R\"(") && !isWord(before()))
        blankUntil(")\"", 2);
      else if (text_[at_] == '"' || (text_[at_] == '\'' && !isWord(before())))
        blankLiteral(text_[at_]);
      else
        code_ += text_[at_++];
    }
    return code_;
  }

 private:
  static bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
  char before() const { return at_ > 0 ? text_[at_ - 1] : '\n'; }
  bool startsLine() const { return before() == '\n'; }
  bool follows(std::string_view what) const { return text_.substr(at_, what.size()) == what; }
  std::size_t firstNonBlank() const {
    const std::size_t place = text_.find_first_not_of(" \t", at_);
    return std::min(place, text_.size() - 1);
  }
  void blank() {
    code_ += text_[at_] == '\n' ? '\n' : ' ';
    ++at_;
  }
  void blankUntil(std::string_view end, std::size_t taken) {
    const std::size_t place = std::min(text_.find(end, at_ + 1), text_.size());
    const std::size_t last = std::min(place + taken, text_.size());
    while (at_ < last) blank();
  }
  void blankDirective() {
    while (at_ < text_.size() && (text_[at_] != '\n' || before() == '\\')) blank();
  }
  /// Leaves an x in its place: a literal is an operand.
  void blankLiteral(char quote) {
    ++at_;
    code_ += 'x';
    while (at_ < text_.size() && text_[at_] != quote) {
      if (text_[at_] == '\\') blank();
      if (at_ < text_.size()) blank();
    }
    if (at_ < text_.size()) blank();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string code_;
};

}  // namespace

std::string readSource(const std::string& path) {
  std::ifstream stream(checkout / path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<SourceFile> sourcesBelow(const std::string& folder, const std::vector<std::string_view>& endings) {
  std::vector<SourceFile> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(checkout / folder)) {
    const std::string path = entry.path().lexically_relative(checkout).generic_string();
    const bool wanted =
        std::any_of(endings.begin(), endings.end(), [&](auto ending) { return path.ends_with(ending); });
    if (wanted && entry.is_regular_file()) files.push_back({path, readSource(path)});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

std::vector<SourceFile> productSources(const std::vector<std::string_view>& endings) {
  std::vector<SourceFile> files;
  for (const char* folder : {"app", "io", "rendering", "resources", "viewer"})
    std::ranges::move(sourcesBelow(folder, endings), std::back_inserter(files));
  return files;
}

std::string codeOf(std::string_view text) { return Blanker(text).run(); }

}  // namespace fenestra::tests
