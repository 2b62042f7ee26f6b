#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/VolumeWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::volumeWriterTest {
namespace fs = std::filesystem;

namespace {

template <class T>
Volume volumeOf(const std::vector<T>& values, glm::ivec3 dims) {
  Volume volume;
  volume.grid.dims = dims;
  volume.grid.spacing = {0.7, 1.3, 2.1};
  volume.grid.origin = {-123.4, 56.78, 901.2};
  const double turn = 0.3;
  volume.grid.direction = glm::dmat3(std::cos(turn), std::sin(turn), 0, -std::sin(turn), std::cos(turn), 0, 0, 0, 1);
  volume.voxels = Voxels(scalarTypeOf<T>(), values.size());
  std::copy(values.begin(), values.end(), volume.voxels.as<T>().begin());
  volume.computeRange();
  return volume;
}

constexpr const char* endings[] = {".mha", ".nii", ".nii.gz", ".nrrd"};

/// NIfTI-1 keeps geometry in single precision: 1e-7 of a metre is 1e-4 mm.
double geometryTolerance(const std::string& ending) { return ending.starts_with(".nii") ? 1e-4 : 1e-10; }

void expectRoundTrip(const Volume& volume, ScalarType type) {
  for (const std::string ending : endings) {
    SCOPED_TRACE(ending);
    const fs::path path = scratchFolder() / ("out" + ending);
    io::writeVolume(volume, path);
    const io::OpenedVolume opened = io::openVolume(path);
    EXPECT_EQ(opened.volume->voxels.type(), type);
    EXPECT_EQ(opened.volume->slope, 1.0);
    expectSameGrid(opened.volume->grid, volume.grid, geometryTolerance(ending));
    const std::vector<double> expected = realValues(volume), actual = realValues(*opened.volume);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      if (std::isnan(expected[i]))
        EXPECT_TRUE(std::isnan(actual[i]));
      else if (type == ScalarType::Float32)
        EXPECT_EQ(actual[i], static_cast<double>(static_cast<float>(expected[i])));
      else
        EXPECT_EQ(actual[i], expected[i]);
    }
  }
}

}  // namespace

TEST(VolumeWriter, RoundTripsEveryTypeInTheNarrowest) {
  expectRoundTrip(volumeOf<std::uint8_t>({0, 1, 2, 200, 255, 9, 8, 7}, {2, 2, 2}), ScalarType::UInt8);
  expectRoundTrip(volumeOf<std::int16_t>({-128, 1, 2, 3, 127, 9, 8, 7}, {2, 2, 2}), ScalarType::Int8);
  expectRoundTrip(volumeOf<std::int32_t>({0, 1, 2, 3, 65535, 9, 8, 7}, {2, 2, 2}), ScalarType::UInt16);
  expectRoundTrip(volumeOf<std::int32_t>({-1024, 1, 2, 3, 3071, 9, 8, 7}, {2, 2, 2}), ScalarType::Int16);
  expectRoundTrip(volumeOf<std::uint32_t>({0, 1, 2, 4000000000u}, {2, 2, 1}), ScalarType::UInt32);
  expectRoundTrip(volumeOf<std::int32_t>({-2000000000, 1, 2, 3}, {2, 2, 1}), ScalarType::Int32);
  expectRoundTrip(volumeOf<float>({0.1f, -2.5f, NAN, INFINITY}, {2, 2, 1}), ScalarType::Float32);
  expectRoundTrip(volumeOf<double>({0.25, -2.5, 3, 4}, {2, 2, 1}), ScalarType::Float32);
  expectRoundTrip(volumeOf<double>({0.1, -2.5, 1e300, 4}, {2, 2, 1}), ScalarType::Float64);
}

TEST(VolumeWriter, WritesRealValues) {
  Volume volume = volumeOf<std::uint16_t>({0, 1000, 2000, 4095}, {2, 2, 1});
  volume.intercept = -1024;
  expectRoundTrip(volume, ScalarType::Int16);
  volume.slope = 0.3;
  expectRoundTrip(volume, ScalarType::Float32);
}

TEST(VolumeWriter, KeepsShearAndMirroring) {
  Volume volume = volumeOf<std::uint8_t>({1, 2, 3, 4, 5, 6, 7, 8}, {2, 2, 2});
  const double tilt = 18.5 * std::numbers::pi / 180.0;
  volume.grid.direction = glm::dmat3(1, 0, 0, 0, std::cos(tilt), -std::sin(tilt), 0, 0, 1);
  expectRoundTrip(volume, ScalarType::UInt8);
  volume.grid.direction = glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1);
  expectRoundTrip(volume, ScalarType::UInt8);
}

TEST(VolumeWriter, LongAxesBecomeNifti2) {
  const Volume volume = volumeOf<std::uint8_t>(std::vector<std::uint8_t>(40000, 3), {40000, 1, 1});
  const fs::path path = scratchFolder() / "long.nii";
  io::writeVolume(volume, path);
  EXPECT_EQ(io::openVolume(path).volume->grid.dims, glm::ivec3(40000, 1, 1));
}

TEST(VolumeWriter, FailuresLeaveNoFile) {
  const Volume volume = volumeOf<std::uint8_t>({1}, {1, 1, 1});
  const fs::path folder = scratchFolder();
  EXPECT_NE(errorOf([&] { io::writeVolume(volume, folder / "out.png"); }).find("names no volume format"),
            std::string::npos);
  EXPECT_NE(
      errorOf([&] { io::writeVolume(volume, folder / "missing" / "out.mha"); }).find("out.mha: cannot be written"),
      std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace fenestra::tests::volumeWriterTest
