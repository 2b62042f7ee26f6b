// What a set of paths means.

#include <fstream>

#include <gtest/gtest.h>

#include "io/base/Error.h"
#include "io/study/Interpret.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::interpretTest {
namespace {

TEST(Interpret, OnePathIsTheVolume) { EXPECT_EQ(io::interpret({"/a/b"}).path, "/a/b"); }

TEST(Interpret, FilesOfOneFolderAreSlices) {
  const io::DataRequest opened = io::interpret({"/a/1.dcm", "/a/2.dcm", "/a/IM0003"});
  EXPECT_EQ(opened.path, "/a");
  EXPECT_TRUE(opened.labels.empty());
}

TEST(Interpret, TwoVolumeFilesAreAVolumeAndItsLabels) {
  const io::DataRequest opened = io::interpret({"/a/ct.nii.gz", "/a/labels.NRRD"});
  EXPECT_EQ(opened.path, "/a/ct.nii.gz");
  EXPECT_EQ(opened.labels, "/a/labels.NRRD");
  EXPECT_THROW(io::interpret({"/a/ct.nii", "/a/b.nii", "/a/c.nii"}), io::Error);
}

TEST(Interpret, LabelsMayComeFirst) {
  const io::DataRequest opened = io::interpret({"/a/CT_seg.nii.gz", "/b/ct.nii.gz"});
  EXPECT_EQ(opened.path, "/b/ct.nii.gz");
  EXPECT_EQ(opened.labels, "/a/CT_seg.nii.gz");
  EXPECT_EQ(io::interpret({"/a/labels1.nrrd", "/a/labels2.nrrd"}).path, "/a/labels1.nrrd");
}

TEST(Interpret, AFolderIsTheVolumeAndAFileBesideItItsLabels) {
  const std::filesystem::path root = scratchFolder(), series = root / "series", labels = root / "seg.dcm";
  std::filesystem::create_directories(series);
  for (const auto& order : {std::vector{series, labels}, std::vector{labels, series}}) {
    EXPECT_EQ(io::interpret(order).path, series);
    EXPECT_EQ(io::interpret(order).labels, labels);
  }
}

TEST(Interpret, AFolderOfMasksIsTheLabels) {
  const std::filesystem::path root = scratchFolder(), masks = root / "segmentations", volume = root / "ct.nii.gz",
                              series = root / "series";
  for (const auto& folder : {masks, series}) std::filesystem::create_directories(folder);
  EXPECT_EQ(io::interpret({masks, volume}).path, masks) << "it holds nothing";
  EXPECT_FALSE(io::mayBeLabels(masks));
  std::ofstream(masks / "liver.nii.gz") << "x";
  EXPECT_TRUE(io::mayBeLabels(masks));
  for (const std::filesystem::path& data : {volume, series})
    for (const auto& order : {std::vector{masks, data}, std::vector{data, masks}}) {
      EXPECT_EQ(io::interpret(order).path, data);
      EXPECT_EQ(io::interpret(order).labels, masks);
    }
}

TEST(Interpret, SeveralFoldersAreOpenedTogetherWhereNothingElseLiesBesideThem) {
  const std::filesystem::path root = scratchFolder();
  for (const char* name : {"study/1", "study/2"}) std::filesystem::create_directories(root / name);
  EXPECT_EQ(io::interpret({root / "study/2", root / "study/1"}).path, root / "study");
  std::filesystem::create_directories(root / "study/3");
  EXPECT_THROW(io::interpret({root / "study/2", root / "study/1"}), io::Error);
}

}  // namespace
}  // namespace fenestra::tests::interpretTest
