#pragma once
// Values of DICOM attributes out of DCMTK's items, whatever the VR that a server gave them. A text counts up to its
// first NUL, without blanks around it (`trimmed` of Text.h). Include in .cpp files alone.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "io/dicom/Dcmtk.h"

namespace fenestra::io {

/// A decimal string (PS3.5 table 6.2-1) as a number; empty when it is none or not finite. A decimal comma, which the
/// standard forbids, is read as the point that it stands for: usesDecimalCommas() tells of it.
std::optional<double> decimalIn(std::string_view text);
/// A number as a decimal string: with as many digits as its 16 characters hold. It must be finite.
std::string decimalText(double value);
/// Whether a decimal string of `item` or of what is nested in it is written with a comma.
bool usesDecimalCommas(DcmItem& item);
/// Empty when the attribute is absent or holds no finite number there. Number strings may have any VR of text.
std::optional<double> numberOf(DcmItem& item, const DcmTagKey& tag, unsigned long position = 0);
/// A value of any integer VR, or a number string.
std::optional<std::int64_t> integerOf(DcmItem& item, const DcmTagKey& tag);
std::string textOf(DcmItem& item, const DcmTagKey& tag);
/// A coded string (PS3.5 6.2, CS): its letters are capitals, though some writers use small ones.
std::string codeOf(DcmItem& item, const DcmTagKey& tag);
/// Text that an operator typed, as UTF-8; of an unknown character set only the ASCII part. `dataset` names the
/// character set where `item` is nested in it.
std::string typedTextOf(DcmItem& item, const DcmTagKey& tag, DcmItem* dataset = nullptr);
/// A private attribute: `creator` names the owner of the block of `group` that holds it (PS3.5 7.8.1). Empty when the
/// owner has no block there. `element` are the last two digits.
std::optional<DcmTagKey> privateTag(DcmItem& item, Uint16 group, const char* creator, Uint16 element);
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
