// Time points of files and series that hold several volumes of one place.

#include <algorithm>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/io/NiftiBytes.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::timePointTest {
namespace fs = std::filesystem;

namespace {

constexpr int voxels = 24, times = 3;

std::vector<std::int16_t> counting() {
  std::vector<std::int16_t> values;
  for (int i = 0; i < voxels * times; ++i) values.push_back(static_cast<std::int16_t>(i * 5 - 100));
  return values;
}

/// Each time point's values come out, by its number and by its id, and the others are listed.
void expectTimePoints(const fs::path& path, const std::string& id, const std::vector<std::int16_t>& values) {
  SCOPED_TRACE(path.filename().string());
  const std::vector<io::SeriesInfo> listed = io::listSeries(path);
  ASSERT_EQ(listed.size(), static_cast<std::size_t>(times));
  for (int time = 1; time <= times; ++time) {
    const auto first = values.begin() + (time - 1) * voxels;
    const std::vector<double> expected(first, first + voxels);
    const io::SeriesInfo& info = listed[static_cast<std::size_t>(time - 1)];
    EXPECT_EQ(info.id, time == 1 ? id : std::string(id).append("#").append(std::to_string(time)));
    EXPECT_EQ(info.time, time);
    EXPECT_EQ(info.times, times);
    const io::OpenedVolume opened = io::openVolume(path, {.time = time});
    EXPECT_EQ(realValues(*opened.volume), expected);
    EXPECT_EQ(opened.series.id, info.id);
    EXPECT_EQ(opened.otherSeries.size(), static_cast<std::size_t>(times - 1));
    const std::string text = commandLineText(warningOf(opened.warnings, io::Warning::Kind::TimePoints));
    const std::string said = std::string("number ").append(std::to_string(time)).append(" is shown; --time N chooses");
    EXPECT_NE(text.find(said), std::string::npos) << text;
    EXPECT_EQ(realValues(*io::openVolume(path, {.series = info.id}).volume), expected);
  }
  for (const int time : {-1, 0, times + 1})
    EXPECT_NE(errorOf([&] { io::openVolume(path, {.time = time}); }).find("numbered from 1 to 3"), std::string::npos);
  EXPECT_NE(errorOf([&] { io::openVolume(path, {.series = "other"}); }).find("no series other"), std::string::npos);
}

const std::string nrrd = "NRRD0004\ntype: short\ndimension: 4\nendian: little\n";

}  // namespace

TEST(TimePoint, OfNifti) {
  const fs::path folder = scratchFolder();
  const std::string bytes = niftiHeader({.dims = {2, 3, 4, times}}) + bytesOf(counting());
  writeFile(folder / "a.nii", bytes);
  expectTimePoints(folder / "a.nii", "a.nii", counting());
  writeFile(folder / "a.nii.gz", gzipped(bytes));
  expectTimePoints(folder / "a.nii.gz", "a.nii.gz", counting());
}

TEST(TimePoint, OfMetaImage) {
  const fs::path path = scratchFolder() / "a.mha";
  writeFile(path,
            "NDims = 4\nDimSize = 2 3 4 3\nElementSpacing = 1 1 1 1\nElementType = MET_SHORT\nElementDataFile = "
            "LOCAL\n" +
                bytesOf(counting()));
  expectTimePoints(path, "a.mha", counting());
}

TEST(TimePoint, OfNrrdInASpaceWithTime) {
  const fs::path path = scratchFolder() / "a.nrrd";
  writeFile(path, nrrd + "space: RAST\nsizes: 2 3 4 3\nspace directions: (2,0,0,0) (0,2,0,0) (0,0,2,0) (0,0,0,1.5)\n" +
                      "space origin: (1,2,3,0)\nencoding: raw\n\n" + bytesOf(counting()));
  expectTimePoints(path, "a.nrrd", counting());
  const Grid grid = io::openVolume(path).volume->grid;
  EXPECT_EQ(grid.origin, glm::dvec3(-1, -2, 3));
  EXPECT_EQ(grid.spacing, glm::dvec3(2));
}

TEST(TimePoint, OfNrrdWithTimeAsItsFastestAxis) {
  const fs::path path = scratchFolder() / "a.nrrd";
  std::vector<std::int16_t> interleaved;
  for (int voxel = 0; voxel < voxels; ++voxel)
    for (int time = 0; time < times; ++time)
      interleaved.push_back(counting()[static_cast<std::size_t>(time * voxels + voxel)]);
  writeFile(path, nrrd +
                      "space: LPS\nsizes: 3 2 3 4\nkinds: time domain domain domain\nspace directions: none (1,0,0) "
                      "(0,1,0) (0,0,1)\nencoding: raw\n\n" +
                      bytesOf(interleaved));
  expectTimePoints(path, "a.nrrd", counting());
}

TEST(TimePoint, OfNrrdInAFileEach) {
  const fs::path folder = scratchFolder();
  const std::string all = bytesOf(counting());
  for (std::size_t time = 0; time < 3; ++time)
    writeFile(folder / std::string("t").append(std::to_string(time)).append(".raw"), all.substr(time * 48, 48));
  writeFile(folder / "a.nhdr", nrrd +
                                   "space: LPS\nsizes: 2 3 4 3\nspace directions: (1,0,0) (0,1,0) (0,0,1) none\n"
                                   "encoding: raw\ndata file: LIST\nt0.raw\nt1.raw\nt2.raw\n");
  expectTimePoints(folder / "a.nhdr", "a.nhdr", counting());
}

TEST(TimePoint, OfADicomSeries) {
  const fs::path folder = scratchFolder();
  std::vector<std::int16_t> values;
  for (int time = 0; time < times; ++time)
    for (int slice = 0; slice < 2; ++slice) {
      DicomSpec spec;
      spec.instance = "1.2." + std::to_string(time * 10 + slice + 1);
      spec.acquisitionNumber = time + 1;
      spec.position = glm::dvec3(0, 0, slice);
      for (int i = 0; i < 12; ++i) {
        spec.words.push_back(static_cast<std::uint32_t>(100 * time + 20 * slice + i));
        values.push_back(static_cast<std::int16_t>(spec.words.back()));
      }
      writeDicom(folder / spec.instance, spec);
    }
  expectTimePoints(folder, "1.2.3.4", values);
}

TEST(TimePoint, OfARealFile) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "formats/nifti/example_nifti2.nii.gz");
  const std::vector<double> first = realValues(*io::openVolume(path).volume);
  const std::vector<double> second = realValues(*io::openVolume(path, {.time = 2}).volume);
  EXPECT_EQ(first.size(), second.size());
  EXPECT_NE(first, second);
  EXPECT_EQ(realValues(*io::openVolume(path, {.time = 1}).volume), first);
}

}  // namespace fenestra::tests::timePointTest
