#pragma once
// Answers of DICOMweb in JSON (PS3.18 annex F), out of untrusted text. Private to io/archive.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/archive/Records.h"

namespace fenestra::io::archive {

/// The data sets of an answer, without sequences and bulk data; empty when the text has another form.
std::optional<std::vector<Attributes>> attributesInJson(std::string_view text);

/// What a server says about objects that were stored (PS3.18 10.5.3).
struct StoreAnswer {
  bool accepted = false;
  unsigned reason = 0;  ///< of a failure or a warning (PS3.4 B.2.3)
};
/// Empty when the text says nothing about an object.
std::optional<StoreAnswer> storeAnswerIn(std::string_view text);

/// What makes a frame an image of its own: how its samples stand in memory, and what its functional groups, else the
/// object, say of their meaning (PS3.3 C.7.6.16.2.1, .9 and .10).
struct FrameHeader {
  struct Value {
    std::uint32_t tag = 0;
    std::vector<double> numbers;
  };
  int rows = 0, columns = 0, bitsAllocated = 0, bitsStored = 0, highBit = 0;
  bool isSigned = false;
  std::string photometric, modality;
  std::vector<Value> meaning;  ///< spacing, window and rescaling, those that are there

  /// Size of the frame without compression: one sample a pixel, each in whole bytes.
  std::uint64_t bytes() const;
};
/// That of frame `number`, the first one being 1, out of an object's metadata. Empty where the text has another form,
/// and for frames of colours, of bits, of segments, or without such a number.
std::optional<FrameHeader> frameHeaderIn(std::string_view text, int number);

}  // namespace fenestra::io::archive
