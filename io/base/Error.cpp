#include "io/base/Error.h"

#include <algorithm>
#include <utility>

namespace fenestra::io {
namespace {

/// Without NULs, where printed text would end, and with blanks for other control characters: parts of a text come from
/// files.
std::string oneLine(std::string text) {
  std::erase(text, '\0');
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

}  // namespace

Error::Error(std::filesystem::path file, std::string cause, std::string hint)
    : std::runtime_error(file.string() + ": " + oneLine(cause) + (hint.empty() ? "" : "; " + oneLine(hint))),
      file_(std::move(file)),
      cause_(oneLine(std::move(cause))),
      hint_(oneLine(std::move(hint))) {}

Error::Error(std::filesystem::path file, std::string cause, WayOut way)
    : Error(std::move(file), std::move(cause), std::string(commandLineWords(way))) {
  way_ = way;
}

void refuseDamaged(const std::filesystem::path& file, const std::string& cause) {
  throw Error(file, cause, "the file is damaged; get it again from its source");
}

}  // namespace fenestra::io
