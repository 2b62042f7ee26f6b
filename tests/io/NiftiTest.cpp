#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;
using io::Warning;

namespace {

/// NIfTI-1 and NIfTI-2 headers, field by field at the offsets that nifti1.h and nifti2.h give.
struct NiftiSpec {
  bool two = false, swapped = false, pair = false;
  std::vector<std::int64_t> dims{2, 3, 4};
  int datatype = 4;
  float slope = 0, intercept = 0;
  std::vector<double> pixdim{1, 1, 1, 1};
  int qform = 0, sform = 0, units = 2;
  std::vector<double> quatern{0, 0, 0, 0, 0, 0};
  std::vector<double> srow{};
};

std::string headerOf(const NiftiSpec& spec) {
  std::string bytes(spec.two ? 544 : 352, '\0');
  const auto put = [&](std::size_t at, auto value) {
    const std::string text = bytesOf(value, spec.swapped);
    bytes.replace(at, text.size(), text);
  };
  const auto real = [&](std::size_t base1, std::size_t base2, std::size_t index, double value) {
    if (spec.two)
      put(base2 + 8 * index, value);
    else
      put(base1 + 4 * index, static_cast<float>(value));
  };
  const auto length = [&](std::size_t index, std::int64_t value) {
    if (spec.two)
      put(16 + 8 * index, value);
    else
      put(40 + 2 * index, static_cast<std::int16_t>(value));
  };
  put(0, std::int32_t{spec.two ? 540 : 348});
  length(0, static_cast<std::int64_t>(spec.dims.size()));
  for (std::size_t i = 1; i < 8; ++i) length(i, i <= spec.dims.size() ? spec.dims[i - 1] : 1);
  put(spec.two ? 12 : 70, static_cast<std::int16_t>(spec.datatype));
  for (std::size_t i = 0; i < spec.pixdim.size(); ++i) real(76, 104, i, spec.pixdim[i]);
  if (spec.two)
    put(168, std::int64_t{spec.pair ? 0 : 544});
  else
    put(108, spec.pair ? 0.0f : 352.0f);
  real(112, 176, 0, spec.slope);
  real(116, 184, 0, spec.intercept);
  if (spec.two) {
    put(344, std::int32_t{spec.qform});
    put(348, std::int32_t{spec.sform});
    put(500, std::int32_t{spec.units});
  } else {
    put(252, static_cast<std::int16_t>(spec.qform));
    put(254, static_cast<std::int16_t>(spec.sform));
    bytes[123] = static_cast<char>(spec.units);
  }
  for (std::size_t i = 0; i < 6; ++i) real(256, 352, i, spec.quatern[i]);
  for (std::size_t i = 0; i < spec.srow.size(); ++i) real(280, 400, i, spec.srow[i]);
  const std::string magic = std::string(spec.pair ? "ni" : "n+") + (spec.two ? "2" : "1");
  bytes.replace(spec.two ? 4 : 344, magic.size(), magic);
  return bytes;
}

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
      writeFile(path, headerOf({.two = two, .swapped = swapped, .datatype = datatype}) + bytesOf(values, swapped));
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
    writeFile(path, headerOf({.datatype = 1024}) + bytesOf(counting<std::int64_t>(24, first)));
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
  writeFile(path, headerOf({.datatype = 1024}) + bytesOf(counting<std::int64_t>(24, (std::int64_t{1} << 53) - 10)));
  warningOf(io::openVolume(path).warnings, Warning::Kind::PrecisionLoss);
  writeFile(path, headerOf({.datatype = 1024}) + bytesOf(std::vector<std::int64_t>(24, std::int64_t{1} << 60)));
  EXPECT_FALSE(hasWarning(io::openVolume(path).warnings, Warning::Kind::PrecisionLoss));
  writeFile(path, headerOf({.datatype = 1280}) + bytesOf(std::vector<std::uint64_t>(24, ~std::uint64_t{0})));
  warningOf(io::openVolume(path).warnings, Warning::Kind::PrecisionLoss);
}

TEST(Nifti, KeepsDoublesThatFloatsWouldLose) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, headerOf({.datatype = 64}) + bytesOf(std::vector<double>(24, 0.1)));
  EXPECT_EQ(io::openVolume(path).volume->voxels.type(), ScalarType::Float64);
  writeFile(path, headerOf({.datatype = 64}) + bytesOf(std::vector<double>(24, 0.25)));
  EXPECT_EQ(io::openVolume(path).volume->voxels.type(), ScalarType::Float32);
}

TEST(Nifti, NotANumberComesThrough) {
  const fs::path path = scratchFolder() / "image.nii";
  std::vector<float> values(24, 1.5f);
  values[3] = std::numeric_limits<float>::quiet_NaN();
  values[5] = std::numeric_limits<float>::infinity();
  writeFile(path, headerOf({.datatype = 16}) + bytesOf(values));
  const auto volume = io::openVolume(path).volume;
  EXPECT_TRUE(std::isnan(volume->value({1, 1, 0})));
  EXPECT_TRUE(std::isinf(volume->value({1, 2, 0})));
  EXPECT_EQ(volume->range, (ValueRange{1.5, 1.5}));
}

TEST(Nifti, ScalingIsKeptBesideTheStoredValues) {
  const fs::path path = scratchFolder() / "image.nii.gz";
  writeFile(path, gzipped(headerOf({.datatype = 2, .slope = 0.5f, .intercept = -3.0f}) +
                          bytesOf(counting<std::uint8_t>(24))));
  const auto volume = io::openVolume(path).volume;
  EXPECT_EQ(volume->voxels.type(), ScalarType::UInt8);
  EXPECT_EQ(volume->value({1, 0, 0}), -2.5);
}

TEST(Nifti, SformMakesLpsGeometryAndKeepsShear) {
  const fs::path path = scratchFolder() / "image.nii";
  const std::string voxels = bytesOf(counting<std::int16_t>(24));
  writeFile(path, headerOf({.qform = 1, .sform = 2, .srow = {2, 0, 0, 10, 0, 3, 1, 20, 0, 0, 4, 30}}) + voxels);
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
  writeFile(path, headerOf({.pixdim = {-1, 2, 3, 4}, .qform = 1, .quatern = {1, 0, 0, 5, 6, 7}}) +
                      bytesOf(counting<std::int16_t>(24)));
  const io::OpenedVolume opened = io::openVolume(path);
  const glm::dmat4 world = opened.volume->grid.worldFromIndex();
  EXPECT_NEAR(glm::distance(world * glm::dvec4(1, 1, 1, 1), glm::dvec4(-5 - 2, -6 + 3, 7 + 4, 1)), 0.0, 1e-6);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Nifti, MetresAndMicronsBecomeMillimetres) {
  const fs::path path = scratchFolder() / "image.nii";
  const auto spacingIn = [&](int units) {
    writeFile(path, headerOf({.sform = 1, .units = units, .srow = {0.2, 0, 0, 1, 0, 0.2, 0, 0, 0, 0, 0.2, 0}}) +
                        bytesOf(counting<std::int16_t>(24)));
    return io::openVolume(path).volume->grid.spacing.x;
  };
  // The header stores single precision.
  EXPECT_FLOAT_EQ(static_cast<float>(spacingIn(1)), 200.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(spacingIn(3)), 0.0002f);
}

TEST(Nifti, WithoutOrientationItSaysSo) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, headerOf({.pixdim = {1, 2, 3, 4}}) + bytesOf(counting<std::int16_t>(24)));
  const io::OpenedVolume opened = io::openVolume(path);
  warningOf(opened.warnings, Warning::Kind::NoGeometry);
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(2, 3, 4));
}

TEST(Nifti, ShowsTheFirstTimePointAndSaysSo) {
  const fs::path path = scratchFolder() / "image.nii";
  writeFile(path, headerOf({.dims = {2, 3, 4, 5}}) + bytesOf(counting<std::int16_t>(120)));
  const io::OpenedVolume opened = io::openVolume(path);
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::TimePoints).text.find("5 volumes"), std::string::npos);
  EXPECT_EQ(opened.volume->range, (ValueRange{0, 23}));
}

TEST(Nifti, PairsOpenByEitherName) {
  const fs::path folder = scratchFolder();
  writeFile(folder / "a.hdr", headerOf({.pair = true}));
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
  writeFile(path, headerOf({.dims = {2, 3, 4, 1, 3}}) + bytesOf(counting<std::int16_t>(72)));
  EXPECT_NE(errorOf([&] { io::openVolume(path); }).find("vectors of 3 components"), std::string::npos);
  writeFile(path, headerOf({.datatype = 128}) + std::string(72, 'x'));
  EXPECT_NE(errorOf([&] { io::openVolume(path); }).find("colours"), std::string::npos);
}

}  // namespace fenestra::tests
