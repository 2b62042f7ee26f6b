// Every row of the table E.1-1 set on a made object, at the top and deep inside, and what becomes of it under each
// option.

#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "io/deidentify/Cleaner.h"
#include "io/deidentify/Values.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::tests::deidentify_table {
namespace {

using namespace io::deidentify;

constexpr const char* plantedText = "Thorax Mustermann 19770707";
constexpr const char* plantedUid = "1.2.3.4.77";
constexpr const char* otherUid = "1.2.3.4.78";

/// Attributes of the table that DCMTK's dictionary does not have (version 3.6.7, older than they are), and their VRs.
const std::map<std::uint32_t, DcmEVR>& newerThanTheDictionary() {
  static const std::map<std::uint32_t, DcmEVR> list{
      {0x00181204, EVR_DA}, {0x00181205, EVR_DA}, {0x00102161, EVR_UC}, {0x003a0329, EVR_LO}, {0x003a032b, EVR_LO},
      {0x00120022, EVR_LO}, {0x00120073, EVR_LO}, {0x00120032, EVR_LO}, {0x00120041, EVR_LO}, {0x00120043, EVR_LO},
      {0x00120055, EVR_LO}, {0x00120023, EVR_SQ}, {0x30020121, EVR_LO}, {0x30020123, EVR_LT}, {0x3006002d, EVR_DT},
      {0x3006002e, EVR_DT}, {0x3006004d, EVR_SQ}, {0x3006004e, EVR_SQ}, {0x300a0054, EVR_UI}};
  return list;
}

DcmTagKey keyOf(const Row& row) { return {static_cast<Uint16>(row.tag >> 16), static_cast<Uint16>(row.tag & 0xffff)}; }

DcmEVR vrOf(const Row& row) {
  if (row.tag == 0x50000000) return EVR_OW;
  const auto newer = newerThanTheDictionary().find(row.tag);
  return newer != newerThanTheDictionary().end() ? newer->second : DcmTag(keyOf(row)).getEVR();
}

/// A tag that the row stands for.
DcmTagKey exampleOf(const Row& row) {
  const DcmTagKey key = keyOf(row);
  if (row.tag == 0x50000000) return {0x5002, 0x3000};
  return row.mask == ~0u ? key : DcmTagKey(static_cast<Uint16>(key.getGroup() + 2), key.getElement());
}

/// Gives `item` the row's attribute, with a value that tells of a person, or of an instance.
void plant(DcmItem& item, const Row& row) {
  const DcmTag tag(exampleOf(row), DcmVR(vrOf(row)));
  const DcmEVR vr = tag.getEVR();
  if (vr == EVR_SQ) {
    DcmItem* inside = nullptr;
    ASSERT_TRUE(item.findOrCreateSequenceItem(tag, inside, -2).good()) << row.keyword;
    inside->putAndInsertString(DCM_CodeValue, "Muster77");
    inside->putAndInsertString(DCM_CodingSchemeDesignator, "99LOCAL");
    inside->putAndInsertString(DCM_CodeMeaning, plantedText);
    inside->putAndInsertString(DCM_ReferencedSOPInstanceUID, otherUid);
    return;
  }
  const Uint8 bytes[8]{'M', 'u', 's', 't', 'e', 'r', '7', '7'};
  const char* text = vr == EVR_UI                   ? plantedUid
                     : vr == EVR_DA                 ? "19770707"
                     : vr == EVR_TM                 ? "070707"
                     : vr == EVR_DT                 ? "19770707070707"
                     : vr == EVR_AS                 ? "077Y"
                     : vr == EVR_CS                 ? "MUSTER"
                     : vr == EVR_IS || vr == EVR_DS ? "77"
                     : isText(vr)                   ? plantedText
                                                    : nullptr;
  const bool isNumber = vr == EVR_US || vr == EVR_FL || vr == EVR_FD || vr == EVR_SS || vr == EVR_UL;
  const OFCondition put = text       ? item.putAndInsertString(tag, text)
                          : isNumber ? item.putAndInsertString(tag, "0")
                                     : OFCondition(EC_Normal);
  ASSERT_TRUE(put.good()) << row.keyword;
  if (text || isNumber) return;
  if (vr == EVR_OW || vr == EVR_OverlayData || vr == EVR_ox)
    ASSERT_TRUE(item.putAndInsertUint16Array(tag, reinterpret_cast<const Uint16*>(bytes), 4).good()) << row.keyword;
  else {
    // DCMTK's short way takes no unknown VR.
    auto element = std::make_unique<DcmOtherByteOtherWord>(tag);
    ASSERT_TRUE(element->putUint8Array(bytes, 8).good()) << row.keyword << " " << DcmVR(vr).getVRName();
    ASSERT_TRUE(item.insert(element.release()).good()) << row.keyword;
  }
}

std::string bytesOf(DcmElement& element) {
  std::ostringstream text;
  element.print(text);
  return text.str();
}

/// What the table demands, read anew: the strongest of the alternatives that keeps any object valid.
enum class Expected { Gone, Empty, Dummy, Uid, Kept, Cleaned };
Expected expectedOf(const Row& row, const Options& options) {
  if ((options.retainDates && row.dates) || (options.retainUids && row.uids)) return Expected::Kept;
  // Bitmaps and bytes cannot be cleaned, and a word of a fixed list has no harmless part: the profile alone rules.
  const DcmEVR vr = vrOf(row);
  const bool isCleanable = row.mask == ~0u && (vr == EVR_SQ || (isText(vr) && vr != EVR_CS));
  if (isCleanable && ((options.cleanDescriptors && row.descriptors) || (options.cleanGraphics && row.graphics)))
    return Expected::Cleaned;
  const char last = row.actions.back() == '*' ? 'U' : row.actions.back();
  return last == 'X' ? Expected::Gone : last == 'Z' ? Expected::Empty : last == 'D' ? Expected::Dummy : Expected::Uid;
}

void expectDone(DcmItem& item, const Row& row, Expected expected, NewUids& uids, bool keepsUids,
                const std::string& before) {
  SCOPED_TRACE(row.keyword + ", " + row.actions);
  DcmElement* element = nullptr;
  item.findAndGetElement(exampleOf(row), element);
  const bool isSequence = vrOf(row) == EVR_SQ, isUid = vrOf(row) == EVR_UI;
  if (expected == Expected::Cleaned && !isSequence) {
    ASSERT_NE(element, nullptr);
    EXPECT_EQ(textIn(*element), "Thorax");
    return;
  }
  if (expected == Expected::Gone) {
    EXPECT_EQ(element, nullptr);
    return;
  }
  ASSERT_NE(element, nullptr);
  const std::string after = bytesOf(*element);
  if (expected == Expected::Kept && !isSequence) {
    EXPECT_EQ(after, before);
    return;
  }
  if (expected == Expected::Empty) {
    EXPECT_EQ(element->getLength(), 0u);
    return;
  }
  if (isUid) {
    EXPECT_EQ(textIn(*element), uids.of(plantedUid));
    EXPECT_TRUE(textIn(*element).starts_with("2.25."));
    return;
  }
  if (!isSequence) {
    EXPECT_GT(element->getLength(), 0u);
    EXPECT_EQ(after.find("uster"), std::string::npos) << after;
    EXPECT_EQ(after.find("MUSTER"), std::string::npos) << after;
    constexpr std::size_t tagLength = 11;  // (gggg,eeee), which may hold these digits
    EXPECT_EQ(after.find("77", tagLength), std::string::npos) << after;
    return;
  }
  DcmItem* inside = io::firstItem(&item, exampleOf(row));
  ASSERT_NE(inside, nullptr) << "the items stay";
  const std::string kept = keepsUids ? otherUid : uids.of(otherUid);
  EXPECT_EQ(io::textOf(*inside, DCM_ReferencedSOPInstanceUID), kept);
  if (expected != Expected::Dummy && expected != Expected::Cleaned) return;
  EXPECT_EQ(io::textOf(*inside, DCM_CodeMeaning), expected == Expected::Dummy ? dummyText : "Thorax");
  EXPECT_EQ(io::textOf(*inside, DCM_CodeValue), dummyText);
}

const std::vector<std::pair<std::string, Options>>& allOptions() {
  static const std::vector<std::pair<std::string, Options>> list{{"none", {}},
                                                                 {"dates", {.retainDates = true}},
                                                                 {"uids", {.retainUids = true}},
                                                                 {"descriptors", {.cleanDescriptors = true}},
                                                                 {"graphics", {.cleanGraphics = true}},
                                                                 {"all", {true, true, true, true}}};
  return list;
}

/// Cleans an object that holds the row's attribute at the place to which `descend` leads, and looks there.
template <class Descend>
void checkRow(const Row& row, const Options& options, const Descend& descend) {
  DcmDataset object;
  DcmItem& place = descend(object);
  plant(place, row);
  DcmElement* planted = nullptr;
  place.findAndGetElement(exampleOf(row), planted);
  ASSERT_NE(planted, nullptr) << row.keyword;
  const std::string before = bytesOf(*planted);
  NewUids uids;
  Changes changes(false);
  Cleaner(options, uids, changes).clean(object);
  expectDone(place, row, expectedOf(row, options), uids, options.retainUids, before);
}

DcmItem& stay(DcmDataset& object) { return object; }

DcmItem& below(DcmDataset& object) {
  DcmItem* item = &object;
  for (const DcmTagKey& sequence : {DCM_SharedFunctionalGroupsSequence, DCM_DerivationImageSequence}) {
    DcmItem* inside = nullptr;
    EXPECT_TRUE(item->findOrCreateSequenceItem(sequence, inside, -2).good());
    item = inside;
  }
  return *item;
}

class DeidentifyTable : public ::testing::Test {
 protected:
  void SetUp() override { io::prepareDcmtk(); }
};

TEST_F(DeidentifyTable, HoldsEachRowOnce) {
  std::set<std::uint32_t> tags;
  std::size_t dates = 0, uids = 0, descriptors = 0, graphics = 0;
  for (const Row& row : io::deidentify::rows()) {
    EXPECT_TRUE(tags.insert(row.tag).second) << row.keyword;
    dates += row.dates;
    uids += row.uids;
    descriptors += row.descriptors;
    graphics += row.graphics;
  }
  // A row that is lost or changed by an edit shows here. The table's row of private attributes is a rule of the
  // cleaner.
  EXPECT_EQ(tags.size(), 622u);
  EXPECT_EQ(dates, 165u);
  EXPECT_EQ(uids, 60u);
  EXPECT_EQ(descriptors, 125u);
  EXPECT_EQ(graphics, 4u);
}

TEST_F(DeidentifyTable, NamesAttributesThatTheDictionaryKnows) {
  for (const Row& row : io::deidentify::rows()) {
    if (row.mask != ~0u || newerThanTheDictionary().contains(row.tag)) continue;
    DcmTag tag(keyOf(row));
    EXPECT_TRUE(tag.error().good()) << row.keyword;
    std::string name = tag.getTagName();
    if (name.starts_with("RETIRED_")) name.erase(0, 8);
    EXPECT_EQ(name, row.keyword.starts_with("RETIRED_") ? row.keyword.substr(8) : row.keyword);
  }
}

TEST_F(DeidentifyTable, EachRowIsDoneAtTheTop) {
  for (const auto& [name, options] : allOptions()) {
    SCOPED_TRACE(name);
    for (const Row& row : io::deidentify::rows()) checkRow(row, options, stay);
  }
}

TEST_F(DeidentifyTable, EachRowIsDoneDeepInside) {
  for (const auto& [name, options] : allOptions()) {
    SCOPED_TRACE(name);
    for (const Row& row : io::deidentify::rows()) checkRow(row, options, below);
  }
}

}  // namespace
}  // namespace fenestra::tests::deidentify_table
