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
/// A value of any integer VR, or a number string.
std::optional<std::int64_t> integerOf(DcmItem& item, const DcmTagKey& tag);
std::string textOf(DcmItem& item, const DcmTagKey& tag);
/// Text that an operator typed, as UTF-8; of an unknown character set only the ASCII part. `dataset` names the
/// character set where `item` is nested in it.
std::string typedTextOf(DcmItem& item, const DcmTagKey& tag, DcmItem* dataset = nullptr);
/// The first item of a sequence; null when there is none, or no `item`.
DcmItem* firstItem(DcmItem* item, const DcmTagKey& sequence);

/// Calls f(item) for the items of a sequence in their order.
template <class F>
void forEachItem(DcmItem& parent, const DcmTagKey& tag, F&& f) {
  DcmSequenceOfItems* sequence = nullptr;
  if (parent.findAndGetSequence(tag, sequence).bad() || !sequence) return;
  for (DcmObject* next = nullptr; (next = sequence->nextInContainer(next));)
    if (auto* item = dynamic_cast<DcmItem*>(next)) f(*item);
}

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
