#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "rendering/volume/Slice.h"
#include "tests/io/IoTesting.h"
#include "tests/io/MghBytes.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::mghTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

std::vector<std::int16_t> countedVoxels(std::size_t count) {
  std::vector<std::int16_t> voxels(count);
  for (std::size_t i = 0; i < count; ++i) voxels[i] = static_cast<std::int16_t>(100 * static_cast<int>(i) - 700);
  return voxels;
}

}  // namespace

TEST(Mgh, VoxelsAndGeometryComeOutAsStored) {
  const fs::path folder = scratchFolder();
  MghSpec spec;
  spec.spacing = {0.5f, 2.0f, 3.0f};
  spec.centre = {10.0f, 20.0f, 30.0f};
  const auto voxels = countedVoxels(24);
  writeFile(folder / "a.mgh", mghFile(spec, voxels));
  const io::OpenedVolume opened = io::openVolume(folder / "a.mgh");
  EXPECT_EQ(opened.format, "MGH");
  EXPECT_EQ(realValues(*opened.volume), std::vector<double>(voxels.begin(), voxels.end()));
  // Coronal slices: x runs to the left, y down, z to the front. The middle of the index range, dims / 2, lies at the
  // centre (RAS 10, 20, 30 is LPS -10, -20, 30).
  Grid expected;
  expected.dims = {2, 3, 4};
  expected.spacing = {0.5, 2.0, 3.0};
  expected.direction = glm::dmat3(1, 0, 0, 0, 0, -1, 0, -1, 0);
  expected.origin = {-10.0 - 1.0 * 0.5, -20.0 + 2.0 * 3.0, 30.0 + 1.5 * 2.0};
  expectSameGrid(opened.volume->grid, expected, 1e-9);
  EXPECT_TRUE(opened.warnings.empty());
}

TEST(Mgh, EveryScalarTypeAndGzip) {
  const fs::path folder = scratchFolder();
  const auto check = [&](std::int32_t type, const auto& voxels) {
    MghSpec spec;
    spec.type = type;
    for (const char* name : {"plain.mgh", "packed.mgz"}) {
      const std::string bytes = mghFile(spec, voxels);
      writeFile(folder / name, std::string(name).ends_with("z") ? gzipped(bytes) : bytes);
      EXPECT_EQ(realValues(*io::openVolume(folder / name).volume), std::vector<double>(voxels.begin(), voxels.end()))
          << type << ' ' << name;
    }
  };
  std::vector<std::uint8_t> bytes(24, 3);
  bytes[7] = 255;
  check(0, bytes);
  std::vector<std::int32_t> ints(24, -70000);
  ints[5] = 70001;
  check(1, ints);
  std::vector<float> floats(24, 0.25f);
  floats[0] = -1e6f;
  check(3, floats);
  check(4, countedVoxels(24));
  std::vector<std::uint16_t> words(24, 65535);
  words[23] = 0;
  check(10, words);
}

TEST(Mgh, WithoutGeometryItIsCoronalWithAWarning) {
  const fs::path folder = scratchFolder();
  MghSpec spec;
  spec.hasGeometry = false;
  spec.spacing = {9, 9, 9};
  writeFile(folder / "a.mgh", mghFile(spec, countedVoxels(24)));
  const io::OpenedVolume opened = io::openVolume(folder / "a.mgh");
  EXPECT_TRUE(hasWarning(opened.warnings, Warning::Kind::NoGeometry));
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(1.0));
  EXPECT_EQ(orientationLetters(opened.volume->grid.direction[0]), "L");
  EXPECT_EQ(orientationLetters(opened.volume->grid.direction[1]), "I");
  EXPECT_EQ(orientationLetters(opened.volume->grid.direction[2]), "A");
}

TEST(Mgh, FurtherFramesAreSaid) {
  const fs::path folder = scratchFolder();
  MghSpec spec;
  spec.frames = 2;
  writeFile(folder / "a.mgh", mghFile(spec, countedVoxels(48)));
  const io::OpenedVolume opened = io::openVolume(folder / "a.mgh");
  EXPECT_TRUE(hasWarning(opened.warnings, Warning::Kind::TimePoints));
  EXPECT_EQ(opened.volume->voxels.count(), 24u);
}

TEST(Mgh, DamagedFilesAreErrors) {
  const fs::path folder = scratchFolder();
  const auto errorFor = [&](const MghSpec& spec, std::size_t kept) {
    writeFile(folder / "a.mgh", mghFile(spec, countedVoxels(24)).substr(0, kept));
    return errorOf([&] { io::openVolume(folder / "a.mgh"); });
  };
  MghSpec spec;
  EXPECT_NE(errorFor(spec, 290).find("holds"), std::string::npos);
  EXPECT_NE(errorFor(spec, 200).find("its content is something else"), std::string::npos);
  spec.type = 6;  // a tensor
  EXPECT_NE(errorFor(spec, 1000).find("MGH data type 6"), std::string::npos);
  spec.type = 4;
  spec.axes = glm::mat3(0.0f);
  EXPECT_NE(errorFor(spec, 1000).find("no usable geometry"), std::string::npos);
}

}  // namespace fenestra::tests::mghTest
