#include "io/archive/Keys.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "io/base/Text.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::archive {
namespace {

constexpr std::array patientKeys{"PatientName", "PatientID", "IssuerOfPatientID", "PatientBirthDate", "PatientSex"};
constexpr std::array studyKeys{"StudyInstanceUID",
                               "StudyDate",
                               "StudyTime",
                               "AccessionNumber",
                               "StudyID",
                               "StudyDescription",
                               "ModalitiesInStudy",
                               "ReferringPhysicianName",
                               "NumberOfStudyRelatedSeries",
                               "NumberOfStudyRelatedInstances"};
constexpr std::array seriesKeys{"SeriesInstanceUID", "SeriesNumber", "SeriesDescription",
                                "SeriesDate",        "SeriesTime",   "Modality",
                                "BodyPartExamined",  "ProtocolName", "NumberOfSeriesRelatedInstances"};
constexpr std::array imageKeys{"SOPInstanceUID", "SOPClassUID", "InstanceNumber", "NumberOfFrames"};

template <class List>
bool holds(const List& list, const std::string& keyword) {
  return std::find(list.begin(), list.end(), keyword) != list.end();
}

bool isAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

bool areAscii(const Attributes& keys) {
  return std::all_of(keys.begin(), keys.end(), [](const auto& key) { return isAscii(key.second); });
}

/// Empty for a keyword that the dictionary lacks.
std::optional<DcmTag> tagOf(const std::string& keyword) {
  DcmTag tag;
  if (DcmTag::findTagFromName(keyword.c_str(), tag).bad()) return std::nullopt;
  return tag;
}

/// All values of an attribute in ASCII.
std::string arrayOf(DcmItem& item, const DcmTagKey& tag) {
  OFString value;
  if (item.findAndGetOFStringArray(tag, value).bad()) return {};
  std::string text(trimmed(std::string_view(value.data(), value.size())));
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  return text;
}

/// Sets of single bytes, and GB 18030, in which names are written (PS3.3 C.12.1.1.2).
constexpr std::array olderSets{"ISO_IR 100", "ISO_IR 101", "ISO_IR 109", "ISO_IR 110", "ISO_IR 144",
                               "ISO_IR 127", "ISO_IR 126", "ISO_IR 138", "ISO_IR 148", "ISO_IR 203",
                               "ISO_IR 13",  "ISO_IR 166", "GB18030"};

}  // namespace

Level levelOf(const std::string& keyword, Level level) {
  if (holds(patientKeys, keyword)) return Level::Patient;
  if (holds(studyKeys, keyword)) return std::min(level, Level::Study);
  if (holds(seriesKeys, keyword)) return std::min(level, Level::Series);
  return level;
}

std::vector<std::string> wantedAt(Level level) {
  std::vector<std::string> wanted;
  const auto add = [&](const auto& keys) { wanted.insert(wanted.end(), keys.begin(), keys.end()); };
  if (level <= Level::Study) add(patientKeys);
  if (level == Level::Study) add(studyKeys);
  if (level == Level::Series) add(seriesKeys);
  if (level == Level::Image) add(imageKeys);
  return wanted;
}

std::unique_ptr<DcmDataset> identifierOf(Level level, const Attributes& keys, const std::vector<std::string>& wanted) {
  constexpr std::array words{"PATIENT", "STUDY", "SERIES", "IMAGE"};
  auto identifier = std::make_unique<DcmDataset>();
  identifier->putAndInsertString(DCM_QueryRetrieveLevel, words[static_cast<std::size_t>(level)]);
  for (const std::string& keyword : wanted) identifier->insertEmptyElement(tagOf(keyword).value());
  for (const auto& [keyword, value] : keys) {
    const std::optional<DcmTag> tag = tagOf(keyword);
    if (!tag || identifier->putAndInsertString(*tag, value.c_str()).bad()) throw std::invalid_argument(keyword);
  }
  if (!areAscii(keys)) identifier->putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
  return identifier;
}

std::vector<std::string> characterSetsFor(const Attributes& keys, const std::string& preferred) {
  if (areAscii(keys)) return {""};  // which must not name a set (PS3.4 C.2.2.2)
  if (!preferred.empty()) return {preferred};
  std::vector<std::string> sets{"ISO_IR 192"};
  sets.insert(sets.end(), olderSets.begin(), olderSets.end());
  return sets;
}

bool encode(DcmDataset& identifier, const std::string& characterSet) {
  if (characterSet.empty() || characterSet == "ISO_IR 192") return true;
  return identifier.convertCharacterSet(characterSet.c_str()).good();
}

Attributes attributesOf(DcmDataset& answer) {
  Attributes attributes;
  for (DcmObject* next = nullptr; (next = answer.nextInContainer(next));) {
    DcmTag tag = next->getTag();
    if (!next->isLeaf() || tag == DCM_SpecificCharacterSet || tag == DCM_QueryRetrieveLevel) continue;
    const std::string keyword = tag.getTagName();
    if (keyword.empty() || keyword == "Unknown Tag & Data") continue;
    // A converter for each UID and number would take as long as the server takes for the answer.
    const auto* element = static_cast<const DcmElement*>(next);
    std::string value = element->isAffectedBySpecificCharacterSet() ? typedTextOf(answer, tag) : arrayOf(answer, tag);
    if (!value.empty()) attributes[keyword] = std::move(value);
  }
  return attributes;
}

}  // namespace fenestra::io::archive
