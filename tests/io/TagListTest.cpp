// The attributes of a DICOM file as a list.

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "io/base/Error.h"
#include "io/dicom/Dcmtk.h"
#include "io/dicom/TagList.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"

namespace fenestra::io::tagListTest {
namespace {

namespace fs = std::filesystem;
using tests::scratchFolder;

const DicomAttribute* find(const std::vector<DicomAttribute>& attributes, const std::string& tag) {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const DicomAttribute& attribute) { return attribute.tag() == tag; });
  return found == attributes.end() ? nullptr : &*found;
}

/// A CT image with a name in Latin-1 and, within a sequence, in UTF-8; a private block; values that are too long.
fs::path writeRich() {
  const fs::path file = scratchFolder() / "rich.dcm";
  tests::DicomSpec spec;
  spec.description = "Thorax";
  tests::writeDicom(file, spec);
  DcmFileFormat object;
  EXPECT_TRUE(object.loadFile(file.c_str()).good());
  DcmDataset& dataset = *object.getDataset();
  dataset.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
  dataset.putAndInsertString(DCM_PatientName, "M\xfcller^Anna");
  dataset.putAndInsertString(DcmTagKey(0x0029, 0x0010), "ACME 1.0");
  DcmTag known(0x0029, 0x1008, EVR_LO);
  dataset.putAndInsertString(known, "secret");
  dataset.putAndInsertString(DCM_ImageComments, std::string(5000, 'x').c_str());
  const Uint16 many[] = {3, 1, 2};
  dataset.putAndInsertUint16Array(DCM_SimpleFrameList, many, 3);
  DcmItem* item = nullptr;
  EXPECT_TRUE(dataset.findOrCreateSequenceItem(DCM_RequestAttributesSequence, item, -2).good());
  item->putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
  item->putAndInsertString(DCM_ScheduledPerformingPhysicianName, "M\xc3\xbcller^Jan");
  EXPECT_TRUE(object.saveFile(file.c_str(), EXS_LittleEndianExplicit).good());
  return file;
}

TEST(TagList, NamesValuesAndNesting) {
  const std::vector<DicomAttribute> all = readAttributes(writeRich());
  const DicomAttribute* syntax = find(all, "(0002,0010)");
  ASSERT_NE(syntax, nullptr) << "the meta header is listed, too";
  EXPECT_EQ(syntax->value, "1.2.840.10008.1.2.1");
  const DicomAttribute* name = find(all, "(0010,0010)");
  ASSERT_NE(name, nullptr);
  EXPECT_EQ(name->name, "PatientName");
  EXPECT_EQ(name->vr, "PN");
  EXPECT_EQ(name->value, "Müller^Anna") << "of Latin-1";
  const DicomAttribute* requests = find(all, "(0040,0275)");
  ASSERT_NE(requests, nullptr);
  EXPECT_EQ(requests->vr, "SQ");
  ASSERT_EQ(requests->items.size(), 1u);
  const DicomAttribute* physician = find(requests->items[0], "(0040,0006)");
  ASSERT_NE(physician, nullptr);
  EXPECT_EQ(physician->value, "Müller^Jan") << "the item has a character set of its own";
  EXPECT_EQ(find(all, "(0008,1161)")->value, "3\\1\\2");
  EXPECT_EQ(find(all, "(0029,1008)")->creator, "ACME 1.0");
  EXPECT_EQ(find(all, "(0029,1008)")->value, "secret");
  EXPECT_EQ(find(all, "(7FE0,0010)")->value, "24 bytes") << "4 × 3 pixels of 2 bytes";
  EXPECT_LT(find(all, "(0020,4000)")->value.size(), 1100u);
  EXPECT_TRUE(find(all, "(0020,4000)")->value.ends_with("…"));
}

TEST(TagList, HidesValuesWithWhatIsNestedInThem) {
  std::vector<DicomAttribute> all = readAttributes(writeRich());
  hideValues(all, [](const DicomAttribute& attribute) {
    return attribute.name == "PatientName" || attribute.name == "RequestAttributesSequence";
  });
  EXPECT_TRUE(find(all, "(0010,0010)")->isHidden);
  EXPECT_EQ(find(all, "(0010,0010)")->value, "");
  EXPECT_EQ(find(find(all, "(0040,0275)")->items[0], "(0040,0006)")->value, "");
  EXPECT_EQ(find(all, "(0008,103E)")->value, "Thorax");
}

TEST(TagList, FindsByTagNameAndValueWithTheSequencesAround) {
  const std::vector<DicomAttribute> all = readAttributes(writeRich());
  EXPECT_EQ(attributesWith(all, "0010,0010").size(), 1u);
  EXPECT_EQ(attributesWith(all, "thorax").size(), 1u);
  const std::vector<DicomAttribute> nested = attributesWith(all, "jan");
  ASSERT_EQ(nested.size(), 1u);
  EXPECT_EQ(nested[0].name, "RequestAttributesSequence");
  ASSERT_EQ(nested[0].items.size(), 1u);
  EXPECT_EQ(nested[0].items[0].size(), 1u);
  EXPECT_TRUE(attributesWith(all, "nowhere").empty());
}

TEST(TagList, SaysHowLongCompressedPixelsAre) {
  const fs::path file = scratchFolder() / "rle.dcm";
  tests::writeDicom(file, tests::pictureSpec(tests::Syntax::Rle));
  const std::vector<DicomAttribute> all = readAttributes(file);
  EXPECT_TRUE(find(all, "(7FE0,0010)")->value.ends_with(" bytes, compressed")) << find(all, "(7FE0,0010)")->value;
}

TEST(TagList, RefusesOtherFiles) {
  const fs::path file = scratchFolder() / "text.dcm";
  std::ofstream(file) << "no DICOM";
  EXPECT_THROW(readAttributes(file), Error);
}

}  // namespace
}  // namespace fenestra::io::tagListTest
