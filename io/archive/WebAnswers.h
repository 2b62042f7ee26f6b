#pragma once
// Answers of DICOMweb in JSON (PS3.18 annex F), out of untrusted text. Private to io/archive.

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

}  // namespace fenestra::io::archive
