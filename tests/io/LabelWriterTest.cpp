// Labels written and read back; segmentations also with DCMTK's own reader.

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include "io/LabelReader.h"
#include "io/LabelWriter.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::labelWriterTest {
namespace fs = std::filesystem;

namespace {

/// Labels 1 to 3 on an oblique, sheared, mirrored grid of 7 x 5 x 4 voxels; 2 has a name that NRRD must escape.
LabelMap sampleLabels() {
  LabelMap map;
  map.grid = labelGrid({7, 5, 4}, {-12.25, 30.5, 101.125}, {0.7, 0.9, 2.5});
  const glm::dvec3 step = glm::normalize(glm::dvec3(0.1, -0.3, -2.0));
  map.grid.direction = {glm::dvec3(0.8, 0.6, 0), glm::dvec3(-0.6, 0.8, 0), step};
  map.labels = {{1, "Leber", {1, 0.5, 0}}, {2, "a\\b größer", {0.1, 0.2, 0.9}}, {3, "third", {0, 1, 0}}};
  map.voxels = Voxels(ScalarType::UInt8, map.grid.voxelCount());
  for (std::size_t i = 0; i < map.voxels.count(); ++i)
    map.voxels.as<std::uint8_t>()[i] = static_cast<std::uint8_t>(i * 7 % 11 < 4 ? i * 7 % 11 : 0);
  return map;
}

}  // namespace

TEST(LabelWriter, EveryFormatGivesTheSameVoxelsBack) {
  const LabelMap map = sampleLabels();
  const fs::path folder = scratchFolder();
  for (const char* name : {"a.nrrd", "a.nii.gz", "a.nii", "a.mha", "a.dcm"}) {
    SCOPED_TRACE(name);
    io::writeLabels(map, folder / name);
    const io::OpenedLabels opened = io::openLabels(folder / name, map.grid);
    expectSameLabels(*opened.labels, map);
    EXPECT_TRUE(opened.warnings.empty()) << opened.warnings.front().text;
  }
  EXPECT_EQ(io::openLabels(folder / "a.nrrd", map.grid).labels->labels, map.labels);
}

TEST(LabelWriter, SegmentationsKeepNamesAndColours) {
  const LabelMap map = sampleLabels();
  const fs::path path = scratchFolder() / "a.dcm";
  io::writeLabels(map, path);
  const auto read = io::openLabels(path, map.grid).labels;
  ASSERT_EQ(read->labels.size(), 3u);
  EXPECT_EQ(read->find(1)->name, "Leber");
  EXPECT_EQ(read->find(2)->name, "a/b größer");  // a backslash divides values in DICOM
  for (const Label& label : map.labels)
    // 16 bits of CIELab keep more than 8 bits of sRGB.
    EXPECT_LT(glm::distance(read->find(label.value)->colour, label.colour), 0.002) << label.name;
}

TEST(LabelWriter, OnlySomeLabels) {
  const LabelMap map = sampleLabels();
  const fs::path folder = scratchFolder();
  LabelMap expected = sampleLabels();
  for (std::uint8_t& value : expected.voxels.as<std::uint8_t>())
    if (value != 3) value = 0;
  io::writeLabels(map, folder / "a.nrrd", {.only = {3}});
  const auto nrrd = io::openLabels(folder / "a.nrrd", map.grid).labels;
  expectSameLabels(*nrrd, expected);
  ASSERT_EQ(nrrd->labels.size(), 1u);
  EXPECT_EQ(nrrd->labels[0], map.labels[2]);
  // Segments are numbered from 1.
  io::writeLabels(map, folder / "a.dcm", {.only = {3}});
  for (std::uint8_t& value : expected.voxels.as<std::uint8_t>()) value = value == 3;
  const auto seg = io::openLabels(folder / "a.dcm", map.grid).labels;
  expectSameLabels(*seg, expected);
  EXPECT_EQ(seg->find(1)->name, "third");
}

TEST(LabelWriter, SegmentationsBelongToTheirSeries) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 3; ++i) {
    DicomSpec slice;
    slice.columns = 5;
    slice.rows = 3;
    slice.instance = "1.2.3.4." + std::to_string(i);
    slice.position = glm::dvec3(0, 0, 2 * i);
    slice.patientName = "Doe^Jane";
    writeDicom(folder / ("slice" + std::to_string(i)), slice);
  }
  const io::OpenedVolume volume = io::openVolume(folder);
  LabelMap map;
  map.grid = volume.volume->grid;
  map.labels = {{1, "one", {1, 0, 0}}};
  map.voxels = Voxels(ScalarType::UInt8, map.grid.voxelCount());
  std::fill_n(map.voxels.as<std::uint8_t>().data(), map.voxels.count(), std::uint8_t{0});
  map.voxels.as<std::uint8_t>()[17] = 1;  // on the second slice alone
  io::writeLabels(map, folder / "seg.dcm", {.only = {}, .series = volume.series.files});

  const io::OpenedVolume again = io::openVolume(folder);
  ASSERT_EQ(again.segmentations.size(), 1u);
  EXPECT_EQ(again.segmentations[0].structures, (std::vector<std::string>{"one"}));
  expectSameLabels(*io::openLabels(folder / "seg.dcm", map.grid).labels, map);

  DcmSegmentation* read = nullptr;
  ASSERT_TRUE(DcmSegmentation::loadFile((folder / "seg.dcm").c_str(), read).good());
  const std::unique_ptr<DcmSegmentation> document(read);
  EXPECT_EQ(document->getNumberOfFrames(), 1u);
  EXPECT_TRUE(document->check());
  OFString value;
  document->getPatient().getPatientName(value);
  EXPECT_EQ(value, "Doe^Jane");
  document->getFrameOfReference().getFrameOfReferenceUID(value);
  EXPECT_EQ(value, "1.2.3");
  auto* derived =
      dynamic_cast<FGDerivationImage*>(document->getFunctionalGroups().get(0, DcmFGTypes::EFG_DERIVATIONIMAGE));
  ASSERT_TRUE(derived);
  OFString instance;
  derived->getDerivationImageItems()[0]
      ->getSourceImageItems()[0]
      ->getImageSOPInstanceReference()
      .getReferencedSOPInstanceUID(instance);
  EXPECT_EQ(instance, "1.2.3.4.1");
}

TEST(LabelWriter, RealLabelsComeBackIdentical) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "labelled/totalsegmentator-torso");
  const Grid grid = io::openVolume(folder / "example_ct.nii.gz").volume->grid;
  const auto map = io::openLabels(folder / "example_seg_fast_force_split.nii.gz", grid).labels;
  const fs::path out = scratchFolder();
  for (const char* name : {"a.nrrd", "a.nii.gz"}) {
    io::writeLabels(*map, out / name);
    expectSameLabels(*io::openLabels(out / name, grid).labels, *map);
  }
  io::writeLabels(*map, out / "a.dcm");
  const auto seg = io::openLabels(out / "a.dcm", grid).labels;
  // Segments are numbered from 1 in the order of the labels that are present; names say which is which.
  const std::vector<int> was = valuesOf(*map), is = valuesOf(*seg);
  std::size_t different = 0;
  for (std::size_t i = 0; i < was.size(); ++i) {
    const Label* before = map->find(static_cast<std::uint16_t>(was[i]));
    const Label* after = seg->find(static_cast<std::uint16_t>(is[i]));
    different += (before != nullptr) != (after != nullptr) || (before && before->name != after->name);
  }
  EXPECT_EQ(different, 0u);
  EXPECT_EQ(seg->labels.size(), 61u);
}

TEST(LabelWriter, WhatCannotBeWrittenSaysWhyAndLeavesNothing) {
  const LabelMap map = sampleLabels();
  const fs::path folder = scratchFolder();
  EXPECT_NE(errorOf([&] { io::writeLabels(map, folder / "a.txt"); }).find("no format for labels"), std::string::npos);
  EXPECT_NE(errorOf([&] { io::writeLabels(map, folder / "no/a.dcm"); }).find("cannot be written"), std::string::npos);
  EXPECT_NE(errorOf([&] { io::writeLabels(map, folder / "a.dcm", {.only = {9}}); }).find("no voxel"),
            std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace fenestra::tests::labelWriterTest
