#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/io/NiftiBytes.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::niftiTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

template <class T>
std::vector<T> counting(std::size_t count, T first = T{0}) {
  std::vector<T> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<T>(first + static_cast<T>(i));
  return values;
}

template <class T>
void expectType(int datatype, T first) {
  for (const bool two : {false, true})
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(std::to_string(datatype) + (two ? " NIfTI-2" : " NIfTI-1") + (swapped ? " swapped" : ""));
      const fs::path path = scratchFolder() / "image.nii";
      const std::vector<T> values = counting<T>(24, first);
      writeFile(path, niftiHeader({.two = two, .swapped = swapped, .datatype = datatype}) + bytesOf(values, swapped));
      const io::OpenedVolume opened = io::openVolume(path);
      EXPECT_EQ(opened.format, "NIfTI");
      EXPECT_EQ(realValues(*opened.volume), std::vector<double>(values.begin(), values.end()));
    }
}

}  // namespace

TEST(Nifti, ReadsEveryScalarTypeInBothByteOrders) {
  expectType<std::uint8_t>(2, 230);
  expectType<std::int16_t>(4, -3000);
  expectType<std::int32_t>(8, -100000);
  expectType<float>(16, -2.5f);
  expectType<double>(64, 1e300);
  expectType<std::int8_t>(256, -100);
  expectType<std::uint16_t>(512, 60000);
  expectType<std::uint32_t>(768, 4000000000u);
  expectType<std::int64_t>(1024, -5000000000);
  expectType<std::uint64_t>(1280, 5000000000u);
}

TEST(Nifti, KeepsTheNarrowestIntegerType) {
  const fs::path path = scratchFolder() / "image.nii";
  const auto typeOf = [&](std::int64_t first) {
    writeFile(path, niftiHeader({.datatype = 1024}) + bytesOf(counting<std::int64_t>(24, first)));
    return io::openVolume(path).volume->voxels.type();
  };
  EXPECT_EQ(typeOf(0), ScalarType::UInt8);
  EXPECT_EQ(typeOf(-5), ScalarType::Int8);
  EXPECT_EQ(typeOf(300), ScalarType::UInt16);
  EXPECT_EQ(typeOf(-300), ScalarType::Int16);
  EXPECT_EQ(typeOf(70000), ScalarType::UInt32);
  EXPECT_EQ(typeOf(-70000), ScalarType::Int32);
  EXPECT_EQ(typeOf(5000000000), ScalarType::Float64);
}

TEST(Nifti, SaysWhenA64BitIntegerIsRounded) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, niftiHeader({.datatype = 1024}) + bytesOf(counting<std::int64_t>(24, (std::int64_t{1} << 53) - 10)));
  warningOf(io::openVolume(path).warnings, Warning::Kind::PrecisionLoss);
  writeFile(path, niftiHeader({.datatype = 1024}) + bytesOf(std::vector<std::int64_t>(24, std::int64_t{1} << 60)));
  EXPECT_FALSE(hasWarning(io::openVolume(path).warnings, Warning::Kind::PrecisionLoss));
  writeFile(path, niftiHeader({.datatype = 1280}) + bytesOf(std::vector<std::uint64_t>(24, ~std::uint64_t{0})));
  warningOf(io::openVolume(path).warnings, Warning::Kind::PrecisionLoss);
}

TEST(Nifti, KeepsDoublesThatFloatsWouldLose) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, niftiHeader({.datatype = 64}) + bytesOf(std::vector<double>(24, 0.1)));
  EXPECT_EQ(io::openVolume(path).volume->voxels.type(), ScalarType::Float64);
  writeFile(path, niftiHeader({.datatype = 64}) + bytesOf(std::vector<double>(24, 0.25)));
  EXPECT_EQ(io::openVolume(path).volume->voxels.type(), ScalarType::Float32);
}

TEST(Nifti, NotANumberComesThrough) {
  const fs::path path = scratchFolder() / "image.nii";
  std::vector<float> values(24, 1.5f);
  values[3] = std::numeric_limits<float>::quiet_NaN();
  values[5] = std::numeric_limits<float>::infinity();
  writeFile(path, niftiHeader({.datatype = 16}) + bytesOf(values));
  const auto volume = io::openVolume(path).volume;
  EXPECT_TRUE(std::isnan(volume->value({1, 1, 0})));
  EXPECT_TRUE(std::isinf(volume->value({1, 2, 0})));
  EXPECT_EQ(volume->range, (ValueRange{1.5, 1.5}));
}

TEST(Nifti, ScalingIsKeptBesideTheStoredValues) {
  const fs::path path = scratchFolder() / "image.nii.gz";
  writeFile(path, gzipped(niftiHeader({.datatype = 2, .slope = 0.5f, .intercept = -3.0f}) +
                          bytesOf(counting<std::uint8_t>(24))));
  const auto volume = io::openVolume(path).volume;
  EXPECT_EQ(volume->voxels.type(), ScalarType::UInt8);
  EXPECT_EQ(volume->value({1, 0, 0}), -2.5);
}

TEST(Nifti, SformMakesLpsGeometryAndKeepsShear) {
  const fs::path path = scratchFolder() / "image.nii";
  const std::string voxels = bytesOf(counting<std::int16_t>(24));
  writeFile(path, niftiHeader({.qform = 1, .sform = 2, .srow = {2, 0, 0, 10, 0, 3, 1, 20, 0, 0, 4, 30}}) + voxels);
  const io::OpenedVolume opened = io::openVolume(path);
  const glm::dmat4 world = opened.volume->grid.worldFromIndex();
  EXPECT_EQ(world * glm::dvec4(0, 0, 0, 1), glm::dvec4(-10, -20, 30, 1));
  EXPECT_EQ(world * glm::dvec4(1, 0, 0, 1), glm::dvec4(-12, -20, 30, 1));
  EXPECT_EQ(world * glm::dvec4(0, 1, 0, 1), glm::dvec4(-10, -23, 30, 1));
  const glm::dvec4 sheared = world * glm::dvec4(0, 0, 1, 1);
  EXPECT_NEAR(glm::distance(sheared, glm::dvec4(-10, -21, 34, 1)), 0.0, 1e-12);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Nifti, QformIsUsedWithoutSformAndNothingIsSaidToBeUnknown) {
  const fs::path path = scratchFolder() / "image.nii";
  // b = 1: half a turn about x; qfac -1 turns the third axis round again.
  writeFile(path, niftiHeader({.pixdim = {-1, 2, 3, 4}, .qform = 1, .quatern = {1, 0, 0, 5, 6, 7}}) +
                      bytesOf(counting<std::int16_t>(24)));
  const io::OpenedVolume opened = io::openVolume(path);
  const glm::dmat4 world = opened.volume->grid.worldFromIndex();
  EXPECT_NEAR(glm::distance(world * glm::dvec4(1, 1, 1, 1), glm::dvec4(-5 - 2, -6 + 3, 7 + 4, 1)), 0.0, 1e-6);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Nifti, MetresAndMicronsBecomeMillimetres) {
  const fs::path path = scratchFolder() / "image.nii";
  const auto spacingIn = [&](int units) {
    writeFile(path, niftiHeader({.sform = 1, .units = units, .srow = {0.2, 0, 0, 1, 0, 0.2, 0, 0, 0, 0, 0.2, 0}}) +
                        bytesOf(counting<std::int16_t>(24)));
    return io::openVolume(path).volume->grid.spacing.x;
  };
  // The header stores single precision.
  EXPECT_FLOAT_EQ(static_cast<float>(spacingIn(1)), 200.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(spacingIn(3)), 0.0002f);
}

TEST(Nifti, WithoutOrientationItSaysSo) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, niftiHeader({.pixdim = {1, 2, 3, 4}}) + bytesOf(counting<std::int16_t>(24)));
  const io::OpenedVolume opened = io::openVolume(path);
  warningOf(opened.warnings, Warning::Kind::NoGeometry);
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(2, 3, 4));
}

TEST(Nifti, ShowsTheFirstTimePointAndSaysSo) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, niftiHeader({.dims = {2, 3, 4, 5}}) + bytesOf(counting<std::int16_t>(120)));
  const io::OpenedVolume opened = io::openVolume(path);
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::TimePoints).text.find("5 volumes"), std::string::npos);
  EXPECT_EQ(opened.volume->range, (ValueRange{0, 23}));
}

TEST(Nifti, PairsOpenByEitherName) {
  const fs::path folder = scratchFolder();
  writeFile(folder / "a.hdr", niftiHeader({.pair = true}));
  writeFile(folder / "a.img", bytesOf(counting<std::int16_t>(24)));
  EXPECT_EQ(realValues(*io::openVolume(folder / "a.hdr").volume), realValues(*io::openVolume(folder / "a.img").volume));
  fs::remove(folder / "a.img");
  writeFile(folder / "a.img.gz", gzipped(bytesOf(counting<std::int16_t>(24))));
  EXPECT_EQ(io::openVolume(folder / "a.hdr").volume->range.high, 23.0);
  EXPECT_EQ(io::openVolume(folder / "a.img.gz").volume->range.high, 23.0);
  fs::remove(folder / "a.img.gz");
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "a.hdr"); }).find("does not exist"), std::string::npos);
}

TEST(Nifti, VectorsAndColoursAreRefused) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, niftiHeader({.dims = {2, 3, 4, 1, 3}}) + bytesOf(counting<std::int16_t>(72)));
  EXPECT_NE(errorOf([&] { io::openVolume(path); }).find("vectors of 3 components"), std::string::npos);
  writeFile(path, niftiHeader({.datatype = 128}) + std::string(72, 'x'));
  EXPECT_NE(errorOf([&] { io::openVolume(path); }).find("colours"), std::string::npos);
}

}  // namespace fenestra::tests::niftiTest
