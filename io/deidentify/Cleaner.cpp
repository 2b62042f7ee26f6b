#include "io/deidentify/Cleaner.h"

#include <algorithm>
#include <array>
#include <vector>

#include "io/base/Text.h"
#include "io/deidentify/Method.h"
#include "io/deidentify/Values.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/Mosaic.h"

namespace fenestra::io::deidentify {
namespace {

/// The VR that the standard gives an attribute; EVR_UNKNOWN where it has none such.
DcmEVR standardVr(const DcmTagKey& key) {
  const DcmTag tag(key);
  const DcmEVR vr = tag.getEVR();
  return tag.error().bad() || vr == EVR_UN || vr == EVR_UNKNOWN2B ? EVR_UNKNOWN : vr;
}

bool isUnknown(DcmEVR vr) { return vr == EVR_UN || vr == EVR_UNKNOWN || vr == EVR_UNKNOWN2B; }

/// Codes that follow from what a report or annotation is about keep their meaning where values become dummies (PS3.3
/// C.17.3): which question a value answers, in which unit, by which template.
bool isStructure(const DcmTagKey& key) {
  static const std::array structure{DCM_ConceptNameCodeSequence, DCM_MeasurementUnitsCodeSequence,
                                    DCM_ContentTemplateSequence};
  return std::find(structure.begin(), structure.end(), key) != structure.end();
}

/// Numbers by which other values are read (how many there are, of which kind), and words of a fixed list.
bool isForm(DcmEVR vr) {
  constexpr std::array form{EVR_CS, EVR_US, EVR_SS, EVR_UL, EVR_SL, EVR_UV, EVR_SV, EVR_AT};
  return std::find(form.begin(), form.end(), vr) != form.end();
}

/// Elements of an unknown VR, as servers write those that they do not know: a text gets the VR of the standard, so that
/// it can be examined.
void giveTextItsVr(DcmItem& item) {
  std::vector<DcmElement*> unknown;
  for (DcmObject* next = nullptr; (next = item.nextInContainer(next));)
    if (isUnknown(next->ident()) && next->isLeaf()) unknown.push_back(static_cast<DcmElement*>(next));
  for (DcmElement* element : unknown) {
    const DcmTagKey key = element->getTag();
    const DcmEVR vr = standardVr(key);
    if (!isText(vr) && !isTemporal(vr) && vr != EVR_UI && vr != EVR_AS && vr != EVR_IS && vr != EVR_DS) continue;
    Uint8* bytes = nullptr;
    if (element->getUint8Array(bytes).bad() || !bytes) continue;
    const std::string text(reinterpret_cast<const char*>(bytes), element->getLength());
    item.putAndInsertString(DcmTag(key), text.c_str());
  }
}

/// Schemes whose codes say the same everywhere (PS3.16 section 8, PS3.3 table 8.1-1); codes of others may be anything.
bool isStandardCode(DcmItem& item) {
  constexpr std::array schemes{"DCM",    "SCT",  "SRT", "SNM3", "99SDM", "LN",
                               "RADLEX", "UCUM", "FMA", "I9",   "I10",   "NCIt"};
  const std::string scheme = textOf(item, DCM_CodingSchemeDesignator);
  return std::find(schemes.begin(), schemes.end(), scheme) != schemes.end();
}

bool isCode(const DcmTagKey& key) {
  static const std::array code{DCM_CodeValue, DCM_LongCodeValue, DCM_CodingSchemeDesignator, DCM_CodingSchemeVersion};
  return std::find(code.begin(), code.end(), key) != code.end();
}

/// Pictures of text, which no program here can examine.
bool isBitmap(const DcmTagKey& key) {
  const int group = key.getGroup() & 0xff00;
  return (group == 0x5000 || group == 0x6000) && key.getGroup() % 2 == 0;
}

}  // namespace

void Cleaner::clean(DcmItem& object) {
  giveTextItsVr(object);
  const OwnNames names(object);
  names_ = &names;
  // Two of the numbers in a private header place a mosaic's slices and say nothing of a person (PS3.15 E.3.10).
  const bool isMosaic = codeOf(object, DCM_ImageType).find("MOSAIC") != std::string::npos;
  const auto mosaic = isMosaic ? siemensMosaic(object) : std::nullopt;
  cleanItem(object, Within::Plain);
  names_ = nullptr;
  if (mosaic) writeSiemensMosaic(*mosaic, object);
  writeMethod(object, options_, mosaic.has_value());
}

void Cleaner::cleanItem(DcmItem& item, Within within) {
  giveTextItsVr(item);
  std::vector<DcmElement*> elements;
  for (DcmObject* next = nullptr; (next = item.nextInContainer(next));)
    if (auto* element = dynamic_cast<DcmElement*>(next)) elements.push_back(element);
  const bool keepsCode = within == Within::Clean && isStandardCode(item);
  for (DcmElement* element : elements)
    if (!keepsCode || !isCode(element->getTag())) apply(item, *element, actionFor(*element, within), within);
}

Action Cleaner::actionFor(DcmElement& element, Within within) const {
  const DcmTagKey key = element.getTag();
  if (isBitmap(key)) return Action::Remove;
  const Row* row = key.isPrivate() ? nullptr : rowOf(key.getGroup(), key.getElement());
  if (!row) return unlisted(element, within);
  const Action action = actionOf(*row, options_);
  // A sequence of dummies holds no cleaned text: nobody asked to keep what it says.
  const Action basic = within == Within::Dummy && action == Action::Clean ? basicAction(*row) : action;
  const bool isRaw = isUnknown(element.ident()) && (standardVr(key) == EVR_SQ || basic == Action::NewUid);
  return isRaw && basic != Action::Empty ? Action::Remove : basic;
}

Action Cleaner::unlisted(DcmElement& element, Within within) const {
  const DcmTagKey key = element.getTag();
  const DcmEVR standard = standardVr(key), vr = element.ident();
  constexpr Uint16 pixelGroup = 0x7fe0;
  if (key.isPrivate() || (standard == EVR_UNKNOWN && key.getElement() != 0)) return Action::Remove;
  if (key == DCM_RETIRED_LengthToEnd) return Action::Remove;  // it would be wrong now
  if (key.getGroup() == pixelGroup) return Action::Keep;
  // Neither examined nor cleaned: a text that the file codes as bytes, a sequence whose items stayed unread.
  if ((isText(standard) && !isText(vr)) || (standard == EVR_SQ && vr != EVR_SQ)) return Action::Remove;
  if (isUnknown(vr)) return Action::Keep;
  if (vr == EVR_UI) return namesKind(key) || options_.retainUids ? Action::Keep : Action::NewUid;
  if (vr == EVR_SQ) return within == Within::Dummy && !isStructure(key) ? Action::Dummy : Action::Clean;
  if (vr == EVR_PN) return Action::Empty;
  if (within == Within::Dummy && !isForm(vr)) return Action::Dummy;
  if (isTemporal(vr)) return options_.retainDates ? Action::Keep : Action::Empty;
  if (within == Within::Clean && isText(vr) && vr != EVR_CS) return Action::Clean;
  if (isText(vr) && vr != EVR_CS && names_ && names_->isNamedIn(textIn(element))) return Action::Dummy;
  return Action::Keep;
}

void Cleaner::apply(DcmItem& item, DcmElement& element, Action action, Within within) {
  const bool isSequence = element.ident() == EVR_SQ;
  const Row* row = rowOf(element.getTag().getGroup(), element.getTag().getElement());
  // A sequence that the table does not list is examined item by item; nothing is reported of it as a whole.
  if (isSequence && (action == Action::Keep || (action == Action::Clean && !row)))
    return nested(element, isStructure(element.getTag()) ? Within::Plain : within);
  if (action == Action::Keep) return;
  const Action otherwise = row ? basicAction(*row) : Action::Dummy;
  if (action == Action::Clean && !isSequence && !cleanText(element)) action = otherwise;
  record(element, action);
  switch (action) {
    case Action::Remove:
      delete item.remove(&element);
      return;
    case Action::Empty:
      element.clear();
      return;
    case Action::Dummy:
      if (isSequence) return nested(element, Within::Dummy);
      if (element.ident() == EVR_UI) return replaceUids(element);
      if (element.getTag() == DCM_PatientID && element.getLength() > 0)
        return setText(element, uids_.patientFor(textIn(element)));
      return makeDummy(element);
    case Action::NewUid:
      if (isSequence) return nested(element, within);
      return replaceUids(element);
    case Action::Clean:
      if (isSequence) nested(element, Within::Clean);
      return;
    case Action::Keep:
      return;
  }
}

void Cleaner::nested(DcmElement& sequence, Within within) {
  auto* items = dynamic_cast<DcmSequenceOfItems*>(&sequence);
  for (DcmObject* next = nullptr; items && (next = items->nextInContainer(next));)
    if (auto* item = dynamic_cast<DcmItem*>(next)) cleanItem(*item, within);
}

void Cleaner::replaceUids(DcmElement& element) {
  std::string replaced;
  for (const std::string& uid : split(textIn(element), '\\'))
    replaced.append(replaced.empty() ? "" : "\\").append(uids_.of(trimmed(uid)));
  setText(element, replaced);
}

bool Cleaner::cleanText(DcmElement& element) const {
  if (!isText(element.ident())) return false;
  std::string cleaned;
  for (const std::string& part : split(textIn(element), '\\')) {
    const std::string kept = plainWords(part, names_->words());
    if (!kept.empty()) cleaned.append(cleaned.empty() ? "" : "\\").append(kept);
  }
  if (cleaned.empty()) return false;
  setText(element, cleaned);
  return true;
}

void Cleaner::record(DcmElement& element, Action action) {
  DcmTag tag(element.getTag());
  const bool isPrivate = tag.isPrivate();
  const Row* row = isPrivate ? nullptr : rowOf(tag.getGroup(), tag.getElement());
  const std::string keyword = isPrivate                                ? "private"
                              : row && row->mask == ~std::uint32_t{0}  ? row->keyword
                              : standardVr(tag) == EVR_UNKNOWN && !row ? "unknown"
                                                                       : tag.getTagName();
  changes_.add(numberOf(tag), action, keyword, changes_.keepsValues() ? textIn(element) : std::string());
}

}  // namespace fenestra::io::deidentify
