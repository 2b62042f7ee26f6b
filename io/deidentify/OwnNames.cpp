#include "io/deidentify/OwnNames.h"

#include <algorithm>
#include <array>

#include "io/base/Text.h"
#include "io/deidentify/Values.h"

namespace fenestra::io::deidentify {
namespace {

constexpr std::size_t shortestName = 3, shortestNumber = 4;

bool isNumber(const DcmTagKey& key) {
  static const std::array numbers{DCM_PatientID, DCM_RETIRED_OtherPatientIDs, DCM_AccessionNumber, DCM_PatientBirthDate,
                                  DcmTagKey(0x0010, 0x1090)};
  return std::find(numbers.begin(), numbers.end(), key) != numbers.end();
}

}  // namespace

OwnNames::OwnNames(DcmItem& object) { add(object); }

void OwnNames::add(DcmItem& item) {
  for (DcmObject* next = nullptr; (next = item.nextInContainer(next));) {
    if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(next); sequence && sequence->ident() == EVR_SQ) {
      for (DcmObject* inside = nullptr; (inside = sequence->nextInContainer(inside));)
        if (auto* nested = dynamic_cast<DcmItem*>(inside)) add(*nested);
      continue;
    }
    const bool number = isNumber(next->getTag());
    if (next->ident() != EVR_PN && !number) continue;
    const std::string text = textIn(*static_cast<DcmElement*>(next));
    for (const std::string& word : wordsIn(text))
      if (word.size() >= (number ? shortestNumber : shortestName)) words_.insert(word);
    if (!number) continue;
    for (const std::string& part : split(text, '\\'))
      if (std::string whole = lowered(trimmed(part)); whole.size() >= shortestNumber)
        numbers_.push_back(std::move(whole));
  }
}

bool OwnNames::isNamedIn(std::string_view text) const {
  if (words_.empty()) return false;
  const std::string small = lowered(std::string(text));
  for (const std::string& number : numbers_)
    if (small.find(number) != std::string::npos) return true;
  const std::vector<std::string> found = wordsIn(text);
  return std::any_of(found.begin(), found.end(), [&](const std::string& word) { return words_.contains(word); });
}

}  // namespace fenestra::io::deidentify
