#pragma once
// Values of DICOM attributes out of DCMTK's items. Include in .cpp files alone.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "io/dicom/Dcmtk.h"

namespace fenestra::io {

/// Empty when the attribute is absent or holds no finite number there.
std::optional<double> numberOf(DcmItem& item, const DcmTagKey& tag, unsigned long position = 0);
/// Of any integer VR, or a number string.
std::optional<std::int64_t> integerOf(DcmItem& item, const DcmTagKey& tag);
std::string textOf(DcmItem& item, const DcmTagKey& tag);
/// Text that an operator typed, as UTF-8; of an unknown character set only the ASCII part.
std::string typedTextOf(DcmItem& item, const DcmTagKey& tag);
/// The first item of a sequence; null when there is none, or no `item`.
DcmItem* firstItem(DcmItem* item, const DcmTagKey& sequence);

/// Exactly N finite numbers.
template <int N>
std::optional<glm::vec<N, double>> numbersOf(DcmItem& item, const DcmTagKey& tag) {
  glm::vec<N, double> result;
  for (int i = 0; i < N; ++i) {
    const auto value = numberOf(item, tag, static_cast<unsigned long>(i));
    if (!value) return std::nullopt;
    result[i] = *value;
  }
  return result;
}

}  // namespace fenestra::io
