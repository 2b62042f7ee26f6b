#pragma once
// Integer samples out of their words.

#include <cstdint>

#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Stored bits of integer words, sign extended.
template <class Word>
class StoredIntegers {
 public:
  using Value = std::int64_t;
  explicit StoredIntegers(const PixelFormat& format)
      : shift_(format.highBit + 1 - format.bitsStored),
        mask_(static_cast<Word>(~std::uint64_t{0} >> (64 - format.bitsStored))),
        sign_(format.isSigned ? static_cast<Word>(std::uint64_t{1} << (format.bitsStored - 1)) : Word{0}) {}

  Value operator()(Word word) const {
    const Word bits = static_cast<Word>(static_cast<Word>(word >> shift_) & mask_);
    return static_cast<std::int64_t>(static_cast<Word>(bits ^ sign_)) - static_cast<std::int64_t>(sign_);
  }

 private:
  int shift_;
  Word mask_, sign_;
};

}  // namespace fenestra::io
