// What a set of paths means.

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fenestra::viewer
