#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "rendering/volume/Slice.h"
#include "tests/io/AnalyzeBytes.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::analyzeTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

std::vector<std::int16_t> countedVoxels() {
  std::vector<std::int16_t> voxels(24);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::int16_t>(50 * static_cast<int>(i) - 300);
  return voxels;
}

void writePair(const fs::path& folder, const AnalyzeSpec& spec) {
  writeFile(folder / "a.hdr", analyzeHeader(spec));
  writeFile(folder / "a.img", bytesOf(countedVoxels(), spec.swapped));
}

}  // namespace

TEST(Analyze, VoxelsComeOutAsStoredInEitherByteOrder) {
  const fs::path folder = scratchFolder();
  const auto voxels = countedVoxels();
  for (const bool swapped : {false, true}) {
    AnalyzeSpec spec;
    spec.swapped = swapped;
    writePair(folder, spec);
    for (const char* name : {"a.hdr", "a.img"}) {
      const io::OpenedVolume opened = io::openVolume(folder / name);
      EXPECT_EQ(opened.format, "Analyze");
      EXPECT_EQ(realValues(*opened.volume), std::vector<double>(voxels.begin(), voxels.end()));
      EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(1, 2, 3));
    }
  }
}

// "MayoClinic/Analyze" orientations: where each axis runs to.
TEST(Analyze, OrientationsAreThoseOfTheFormat) {
  const fs::path folder = scratchFolder();
  constexpr std::array<const char*, 6> letters{"LAS", "LSA", "ASL", "LPS", "LIA", "ASR"};
  for (std::size_t orientation = 0; orientation < letters.size(); ++orientation) {
    AnalyzeSpec spec;
    spec.orientation = static_cast<char>(orientation);
    writePair(folder, spec);
    const io::OpenedVolume opened = io::openVolume(folder / "a.hdr");
    std::string found;
    for (int axis = 0; axis < 3; ++axis) found += orientationLetters(opened.volume->grid.direction[axis]);
    EXPECT_EQ(found, letters[orientation]);
    EXPECT_NE(warningOf(opened.warnings, Warning::Kind::NoGeometry).text.find("which side is left"), std::string::npos);
  }
}

TEST(Analyze, SpmsScaleAndOriginHold) {
  const fs::path folder = scratchFolder();
  AnalyzeSpec spec;
  spec.slope = 0.5f;
  spec.origin = {2, 1, 3};
  writePair(folder, spec);
  const io::OpenedVolume opened = io::openVolume(folder / "a.hdr");
  EXPECT_EQ(opened.volume->slope, 0.5);
  // Voxel (1, 0, 2), counted from 0, lies at the origin.
  EXPECT_LT(glm::length(glm::dvec3(opened.volume->grid.worldFromIndex() * glm::dvec4(1, 0, 2, 1))), 1e-9);
}

TEST(Analyze, MissingVoxelSizesAreSaid) {
  const fs::path folder = scratchFolder();
  AnalyzeSpec spec;
  spec.spacing = {0, 2, 3};
  writePair(folder, spec);
  const io::OpenedVolume opened = io::openVolume(folder / "a.hdr");
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::NoGeometry).text.find("taken as 1 mm"), std::string::npos);
}

TEST(Analyze, DamagedFilesAreErrors) {
  const fs::path folder = scratchFolder();
  AnalyzeSpec spec;
  writeFile(folder / "a.hdr", analyzeHeader(spec));
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "a.hdr"); }).find("does not exist"), std::string::npos);
  spec.offset = -4;
  writePair(folder, spec);
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "a.hdr"); }).find("no voxel offset"), std::string::npos);
  spec.offset = 0;
  spec.dims = {2, 3, 40};
  writePair(folder, spec);
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "a.hdr"); }).find("holds"), std::string::npos);
  spec.dims = {2, 3, 4, -1};
  writePair(folder, spec);
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "a.hdr"); }).find("dimension of no length"), std::string::npos);
}

}  // namespace fenestra::tests::analyzeTest
