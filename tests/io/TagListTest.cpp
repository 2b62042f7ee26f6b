// The lists of a file's DICOM attributes.

#include <algorithm>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/dicom/TagList.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::tagListTest {
namespace fs = std::filesystem;
namespace {

const io::DicomTag& tagOf(const std::vector<io::DicomTag>& tags, const std::string& number) {
  const auto at = std::find_if(tags.begin(), tags.end(), [&](const auto& tag) { return tag.number() == number; });
  if (at == tags.end()) throw std::runtime_error("no tag " + number);
  return *at;
}

/// A file with names in Greek, and in an item in Latin 1, private attributes and long ones.
fs::path writeRichFile() {
  const fs::path path = scratchFolder() / "rich.dcm";
  DicomSpec spec;
  spec.patientName = "Yamada^Tarou";
  spec.patientId = "QX-4711";
  spec.kernel = "B30f";
  writeDicom(path, spec);
  DcmFileFormat file;
  EXPECT_TRUE(file.loadFile(path.c_str()).good());
  DcmDataset& dataset = *file.getDataset();
  dataset.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 126");
  dataset.putAndInsertString(DCM_PatientName, "\xc4\xe9\xef\xed\xf5\xf3\xe9\xef\xf2");
  DcmItem* item = nullptr;
  dataset.findOrCreateSequenceItem(DCM_RequestAttributesSequence, item, -2);
  item->putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 100");
  item->putAndInsertString(DCM_ScheduledProcedureStepDescription,
                           "Sch\xe4"
                           "del");
  DcmItem* second = nullptr;
  dataset.findOrCreateSequenceItem(DCM_RequestAttributesSequence, second, -2);
  second->putAndInsertString(DCM_ScheduledProcedureStepDescription, "\xc4");
  dataset.putAndInsertString(DcmTag(0x0029, 0x0010, EVR_LO), "ACME 1.0");
  dataset.putAndInsertString(DcmTag(0x0029, 0x1001, EVR_LO), "Vermeer's secret");
  dataset.putAndInsertUint16(DcmTag(0x0028, 0x1101, EVR_US), 7);
  const std::vector<Uint8> table(70001, 1);
  dataset.putAndInsertUint8Array(DcmTag(0x0042, 0x0011, EVR_OB), table.data(), 70000);
  EXPECT_TRUE(file.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
  return path;
}

}  // namespace

TEST(TagList, TellsNamesTextsAndSizes) {
  const std::vector<io::DicomTag> tags = io::readDicomTags(writeRichFile(), 0);
  EXPECT_EQ(tagOf(tags, "0008,0060").name, "Modality");
  EXPECT_EQ(tagOf(tags, "0008,0060").vr, "CS");
  EXPECT_EQ(tagOf(tags, "0008,0060").value, "CT");
  EXPECT_EQ(tagOf(tags, "0002,0010").value, "1.2.840.10008.1.2.1");
  EXPECT_EQ(tagOf(tags, "0020,0032").value, "0\\0\\0");
  EXPECT_EQ(tagOf(tags, "0010,0010").value, "Διονυσιος");
  EXPECT_EQ(tagOf(tags, "0028,1101").value, "7");
  EXPECT_FALSE(tagOf(tags, "0042,0011").hasText);
  EXPECT_EQ(tagOf(tags, "0042,0011").bytes, 70000u);
  EXPECT_EQ(tagOf(tags, "7fe0,0010").vr, "OW");
  EXPECT_EQ(tagOf(tags, "7fe0,0010").bytes, 24u);  // 4 x 3 pixels of 2 bytes
  EXPECT_EQ(tagOf(tags, "0029,0010").name, "PrivateCreator");
  EXPECT_EQ(tagOf(tags, "0029,1001").creator, "ACME 1.0");
  EXPECT_EQ(tagOf(tags, "0029,1001").value, "Vermeer's secret");
}

TEST(TagList, ItemsHaveCharacterSetsOfTheirOwnOrThatAroundThem) {
  const std::vector<io::DicomTag> tags = io::readDicomTags(writeRichFile(), 0);
  const io::DicomTag& sequence = tagOf(tags, "0040,0275");
  ASSERT_TRUE(sequence.isSequence());
  ASSERT_EQ(sequence.items.size(), 2u);
  EXPECT_EQ(tagOf(sequence.items[0].tags, "0040,0007").value, "Schädel");
  EXPECT_EQ(tagOf(sequence.items[1].tags, "0040,0007").value, "Δ");
}

TEST(TagList, HidesWhatMayIdentifyThePatient) {
  std::vector<io::DicomTag> tags = io::readDicomTags(writeRichFile(), 0);
  io::hidePatient(tags);
  for (const char* number : {"0010,0010", "0010,0020", "0020,000e", "0008,0018", "0029,1001"}) {
    EXPECT_TRUE(tagOf(tags, number).identifies) << number;
    EXPECT_EQ(tagOf(tags, number).value, "") << number;
  }
  EXPECT_EQ(tagOf(tagOf(tags, "0040,0275").items[0].tags, "0040,0007").value, "");
  EXPECT_EQ(tagOf(tags, "0018,1210").value, "B30f");
  EXPECT_EQ(tagOf(tags, "0008,0016").value, "1.2.840.10008.5.1.4.1.1.2");
  EXPECT_TRUE(io::tagsHolding(tags, "Διονυσιος").empty());
}

TEST(TagList, FindsByNumberNameCreatorAndValueWithinSequences) {
  const std::vector<io::DicomTag> tags = io::readDicomTags(writeRichFile(), 0);
  EXPECT_EQ(io::tagsHolding(tags, "").size(), tags.size());
  ASSERT_EQ(io::tagsHolding(tags, "(0018,1210)").size(), 1u);
  EXPECT_EQ(io::tagsHolding(tags, "KERNEL")[0].value, "B30f");
  EXPECT_EQ(io::tagsHolding(tags, "acme").size(), 2u);
  const std::vector<io::DicomTag> found = io::tagsHolding(tags, "schädel");
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].items.size(), 1u);
  EXPECT_EQ(found[0].items[0].number, 1u);
  EXPECT_EQ(found[0].items[0].tags.size(), 1u);
}

TEST(TagList, ListsTheFunctionalGroupsOfOneFrame) {
  const fs::path path = scratchFolder() / "enhanced.dcm";
  DicomSpec spec;
  spec.sopClass = "1.2.840.10008.5.1.4.1.1.2.1";
  for (int i = 0; i < 3; ++i) spec.frames.push_back({.position = {0, 0, 5.0 * (2 - i)}});
  writeDicom(path, spec);
  const io::OpenedVolume opened = io::openVolume(path);
  // Sorted by position, which falls from frame to frame.
  EXPECT_EQ(opened.slices, (std::vector<io::SliceSource>{{0, 2}, {0, 1}, {0, 0}}));
  const std::vector<io::DicomTag> tags = io::readDicomTags(path, 1);
  const io::DicomTag& groups = tagOf(tags, "5200,9230");
  EXPECT_EQ(groups.itemCount, 3u);
  ASSERT_EQ(groups.items.size(), 1u);
  EXPECT_EQ(groups.items[0].number, 2u);
  const io::DicomTag& place = tagOf(groups.items[0].tags, "0020,9113");
  EXPECT_EQ(tagOf(place.items.at(0).tags, "0020,0032").value, "0\\0\\5");
}

TEST(TagList, SlicesKnowTheirFiles) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 5; ++i) {
    DicomSpec spec;
    spec.instance = "1.2.3." + std::to_string(i + 1);
    spec.instanceNumber = i + 1;
    spec.position = glm::dvec3(0, 0, -3.0 * i);
    writeDicom(folder / ("s" + std::to_string((i * 2) % 5)), spec);
  }
  const io::OpenedVolume opened = io::openVolume(folder);
  ASSERT_EQ(opened.slices.size(), 5u);
  for (int k = 0; k < 5; ++k) {
    const io::SliceSource source = opened.slices[static_cast<std::size_t>(k)];
    EXPECT_EQ(source.frame, 0u);
    const auto tags = io::readDicomTags(opened.series.files.at(source.file), source.frame);
    EXPECT_EQ(tagOf(tags, "0020,0013").value, std::to_string(5 - k));
    EXPECT_EQ(std::stod(tagOf(tags, "0020,0032").value.substr(4)), -3.0 * (4 - k));
  }
}

TEST(TagList, FilesThatAreNoDicomAreRefusedByName) {
  const fs::path path = scratchFolder() / "text.dcm";
  writeFile(path, "no header at all");
  EXPECT_NE(errorOf([&] { io::readDicomTags(path, 0); }).find("text.dcm"), std::string::npos);
}

}  // namespace fenestra::tests::tagListTest
