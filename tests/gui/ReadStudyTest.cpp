// What a set of paths means.

#include <gtest/gtest.h>

#include "tests/support/TestData.h"
#include "viewer/jobs/ReadStudy.h"

namespace fenestra::viewer {
namespace {

TEST(Interpret, OnePathIsTheVolume) { EXPECT_EQ(interpret({"/a/b"}).volume, "/a/b"); }

TEST(Interpret, FilesOfOneFolderAreSlices) {
  const PathsToOpen opened = interpret({"/a/1.dcm", "/a/2.dcm", "/a/IM0003"});
  EXPECT_EQ(opened.volume, "/a");
  EXPECT_TRUE(opened.labels.empty());
}

TEST(Interpret, TwoVolumeFilesAreAVolumeAndItsLabels) {
  const PathsToOpen opened = interpret({"/a/ct.nii.gz", "/a/labels.NRRD"});
  EXPECT_EQ(opened.volume, "/a/ct.nii.gz");
  EXPECT_EQ(opened.labels, "/a/labels.NRRD");
  EXPECT_THROW(interpret({"/a/ct.nii", "/a/b.nii", "/a/c.nii"}), io::Error);
}

TEST(Interpret, LabelsMayComeFirst) {
  const PathsToOpen opened = interpret({"/a/CT_seg.nii.gz", "/b/ct.nii.gz"});
  EXPECT_EQ(opened.volume, "/b/ct.nii.gz");
  EXPECT_EQ(opened.labels, "/a/CT_seg.nii.gz");
  EXPECT_EQ(interpret({"/a/labels1.nrrd", "/a/labels2.nrrd"}).volume, "/a/labels1.nrrd");
}

TEST(Interpret, AFolderIsTheVolumeAndAFileBesideItItsLabels) {
  const std::filesystem::path root = tests::scratchFolder(), series = root / "series", labels = root / "seg.dcm";
  std::filesystem::create_directories(series);
  for (const auto& order : {std::vector{series, labels}, std::vector{labels, series}}) {
    EXPECT_EQ(interpret(order).volume, series);
    EXPECT_EQ(interpret(order).labels, labels);
  }
}

TEST(Interpret, SeveralFoldersAreOpenedTogetherWhereNothingElseLiesBesideThem) {
  const std::filesystem::path root = tests::scratchFolder();
  for (const char* name : {"study/1", "study/2"}) std::filesystem::create_directories(root / name);
  EXPECT_EQ(interpret({root / "study/2", root / "study/1"}).volume, root / "study");
  std::filesystem::create_directories(root / "study/3");
  EXPECT_THROW(interpret({root / "study/2", root / "study/1"}), io::Error);
}

}  // namespace
}  // namespace fenestra::viewer
