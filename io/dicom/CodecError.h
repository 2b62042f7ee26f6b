#pragma once
// Why a codestream cannot be decoded, in a few words.

#include <stdexcept>

namespace fenestra::io {

class CodecError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fenestra::io
