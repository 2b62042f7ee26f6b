#include "io/base/Error.h"

#include <utility>

namespace fenestra::io {

Error::Error(std::filesystem::path file, std::string cause, std::string hint)
    : std::runtime_error(file.string() + ": " + cause + (hint.empty() ? "" : "; " + hint)),
      file_(std::move(file)),
      cause_(std::move(cause)),
      hint_(std::move(hint)) {}

}  // namespace fenestra::io
