#include <gtest/gtest.h>

#include "io/LabelColours.h"
#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/io/NiftiBytes.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::labelReaderTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

std::string metaImage(const std::string& geometry, const std::string& dims, const std::string& type,
                      const std::string& data) {
  return "NDims = 3\nDimSize = " + dims + "\n" + geometry + "ElementType = " + type + "\nElementDataFile = LOCAL\n" +
         data;
}

}  // namespace

TEST(Labels, AreReadWithNamesFromATableBeside) {
  const fs::path folder = scratchFolder();
  writeFile(folder / "map.mha", metaImage("ElementSpacing = 1 1 1\n", "2 2 1", "MET_USHORT",
                                          bytesOf(std::vector<std::uint16_t>{0, 1, 2, 7})));
  writeFile(folder / "map.txt", "value name\n1 Left_kidney 2001\n7 Aorta 3\n9 Absent 4\n# comment\n");
  const io::OpenedLabels opened = io::openLabels(folder / "map.mha", labelGrid({2, 2, 1}));
  EXPECT_EQ(valuesOf(*opened.labels), (std::vector<int>{0, 1, 2, 7}));
  EXPECT_EQ(opened.labels->voxels.type(), ScalarType::UInt8);
  ASSERT_EQ(opened.labels->labels.size(), 4u);
  EXPECT_EQ(opened.labels->find(1)->name, "Left_kidney");
  EXPECT_EQ(opened.labels->find(2)->name, "label 2");
  EXPECT_EQ(opened.labels->find(7)->name, "Aorta");
  EXPECT_EQ(opened.labels->find(9)->name, "Absent");
  EXPECT_EQ(opened.labels->find(7)->colour, io::labelColour(7, opened.labels->find(7)->name));
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Labels, TabbedTablesKeepBlanksInNames) {
  const fs::path folder = scratchFolder();
  writeFile(folder / "map.mha", metaImage("", "1 1 1", "MET_UCHAR", "\x01"));
  writeFile(folder / "labels.tsv", "value\tname\n1\tleft kidney\t1 2 3\r\n");
  EXPECT_EQ(io::openLabels(folder / "map.mha", labelGrid({1, 1, 1})).labels->find(1)->name, "left kidney");
}

TEST(Labels, ItkSnapTablesHaveTheNameInQuotes) {
  const fs::path folder = scratchFolder();
  writeFile(folder / "map.mha", metaImage("", "1 1 1", "MET_UCHAR", "\x01"));
  writeFile(folder / "map.txt",
            "# ITK-SnAP Label Description File\n    0     0    0    0        0  0  0    \"Clear Label\"\n    1   255   "
            " 0    0        1  1  1    \"Left kidney\"\n");
  const auto labels = io::openLabels(folder / "map.mha", labelGrid({1, 1, 1})).labels;
  ASSERT_EQ(labels->labels.size(), 1u);
  EXPECT_EQ(labels->find(1)->name, "Left kidney");
}

TEST(Labels, AboveAByteTheyAreSixteenBits) {
  const fs::path path = scratchFolder() / "map.mha";
  writeFile(path, metaImage("", "2 1 1", "MET_INT", bytesOf(std::vector<std::int32_t>{256, 65535})));
  const auto labels = io::openLabels(path, labelGrid({2, 1, 1})).labels;
  EXPECT_EQ(labels->voxels.type(), ScalarType::UInt16);
  EXPECT_EQ(valuesOf(*labels), (std::vector<int>{256, 65535}));
}

TEST(Labels, WholeFloatsAreLabelsOthersAreNot) {
  const fs::path path = scratchFolder() / "map.mha";
  writeFile(path, metaImage("", "2 1 1", "MET_FLOAT", bytesOf(std::vector<float>{0.0f, 3.0f})));
  EXPECT_EQ(valuesOf(*io::openLabels(path, labelGrid({2, 1, 1})).labels), (std::vector<int>{0, 3}));
  for (const float bad : {0.5f, -1.0f, 65536.0f, std::numeric_limits<float>::quiet_NaN()}) {
    writeFile(path, metaImage("", "2 1 1", "MET_FLOAT", bytesOf(std::vector<float>{1.0f, bad})));
    EXPECT_NE(errorOf([&] {
                io::openLabels(path, labelGrid({2, 1, 1}));
              }).find("no label map"),
              std::string::npos)
        << bad;
  }
}

TEST(Labels, MasksThatSpmScalesAreWhole) {
  const fs::path path = scratchFolder() / "mask.nii";
  const auto write = [&](float slope, const std::vector<std::uint8_t>& voxels) {
    NiftiSpec spec{.dims = {3, 1, 1}, .datatype = 2, .slope = slope, .sform = 1};
    spec.srow = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
    writeFile(path, niftiHeader(spec) + bytesOf(voxels));
  };
  write(1.0f / 255.0f, {0, 255, 255});
  EXPECT_EQ(valuesOf(*io::openLabels(path, labelGrid({3, 1, 1})).labels), (std::vector<int>{0, 1, 1}));
  // A probability is no label.
  write(1.0f / 255.0f, {0, 128, 255});
  EXPECT_NE(errorOf([&] {
              io::openLabels(path, labelGrid({3, 1, 1}));
            }).find("holds the value 0.50"),
            std::string::npos);
  // Six digits of a text header.
  writeFile(path, metaImage("ElementToIntensityFunctionSlope = 0.00392157\n", "2 1 1", "MET_UCHAR", "\xFF\xFF"));
  EXPECT_EQ(valuesOf(*io::openLabels(path, labelGrid({2, 1, 1})).labels), (std::vector<int>{1, 1}));
}

TEST(Labels, FlippedAndPermutedLatticesMatchExactly) {
  const fs::path path = scratchFolder() / "map.mha";
  // Index axes of the map: world -y, world z, world -x.
  writeFile(
      path,
      metaImage("TransformMatrix = 0 -1 0 0 0 1 -1 0 0\nElementSpacing = 2 3 1\nOffset = 2 4 0\n", "3 2 3", "MET_UCHAR",
                bytesOf(std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18})));
  Grid target = labelGrid({3, 3, 2});
  target.spacing = {1, 2, 3};
  const io::OpenedLabels opened = io::openLabels(path, target);
  // Target voxel (x, y, z) lies at map index (2 - y, z, 2 - x).
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) EXPECT_EQ(opened.labels->value({x, y, z}), 1 + (2 - y) + 3 * z + 6 * (2 - x));
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  EXPECT_EQ(opened.labels->grid, target);
}

TEST(Labels, OtherGridsAreResampledByNearestAndSaid) {
  const fs::path path = scratchFolder() / "map.mha";
  writeFile(path, metaImage("ElementSpacing = 2 1 1\nOffset = 0.5 0 0\n", "2 1 1", "MET_UCHAR", "\x01\x02"));
  const io::OpenedLabels opened = io::openLabels(path, labelGrid({6, 1, 1}));
  // Voxel 0 reaches from -0.5 to 1.5, voxel 1 from 1.5 to 3.5.
  EXPECT_EQ(valuesOf(*opened.labels), (std::vector<int>{1, 1, 2, 2, 0, 0}));
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::Other).text.find("resampled"), std::string::npos);
}

TEST(Labels, OutsideTheVolumeIsSaid) {
  const fs::path path = scratchFolder() / "map.mha";
  writeFile(path, metaImage("Offset = 1000 0 0\n", "2 1 1", "MET_UCHAR", "\x01\x02"));
  const io::OpenedLabels opened = io::openLabels(path, labelGrid({6, 1, 1}));
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::Other).text.find("outside"), std::string::npos);
}

TEST(Labels, SlicerSegmentsHaveNamesColoursAndLayers) {
  const fs::path path = scratchFolder() / "map.seg.nrrd";
  writeFile(
      path,
      "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: 2 4 1 1\n"
      "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: list domain domain domain\nencoding: raw\nspace origin: "
      "(0,0,0)\n"
      "Segment0_ID:=a\nSegment0_Name:=lung\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Color:=1 0.5 0\n"
      "Segment1_ID:=b\nSegment1_Name:=rib cage\nSegment1_LabelValue:=1\nSegment1_Layer:=1\nSegment1_Color:=0 0 1\n\n" +
          std::string("\x01\x00\x01\x01\x00\x01\x00\x00", 8));
  const io::OpenedLabels opened = io::openLabels(path, labelGrid({4, 1, 1}));
  // The second layer's 1 is another segment, so it gets the next free value; where both are, it stays.
  EXPECT_EQ(valuesOf(*opened.labels), (std::vector<int>{1, 2, 2, 0}));
  EXPECT_EQ(opened.labels->find(1)->name, "lung");
  EXPECT_EQ(opened.labels->find(1)->colour, glm::dvec3(1, 0.5, 0));
  EXPECT_EQ(opened.labels->find(2)->name, "rib cage");
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::Other).text.find("overlap at 1 voxel"), std::string::npos);
}

TEST(Labels, SeveralVolumesWithoutSegmentsAreRefused) {
  const fs::path path = scratchFolder() / "map.nrrd";
  writeFile(path, "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 1 1 1 2\nencoding: raw\n\nab");
  EXPECT_NE(errorOf([&] { io::openLabels(path, labelGrid({1, 1, 1})); }).find("2 volumes"), std::string::npos);
}

}  // namespace fenestra::tests::labelReaderTest
