#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;
using io::Warning;

TEST(Raw, DescriptionsAreParsed) {
  const io::RawDescription full = io::parseRawDescription("256x128x64:uint16:be:skip=512");
  EXPECT_EQ(full.dims, glm::ivec3(256, 128, 64));
  EXPECT_EQ(full.type, ScalarType::UInt16);
  EXPECT_TRUE(full.bigEndian);
  EXPECT_EQ(full.skip, 512u);
  const io::RawDescription plain = io::parseRawDescription("1x2x3:float32");
  EXPECT_EQ(plain.type, ScalarType::Float32);
  EXPECT_FALSE(plain.bigEndian);
  EXPECT_EQ(plain.skip, 0u);
  for (const char* bad : {"", "1x2:uint8", "1x2x3", "0x2x3:uint8", "1x2x-3:uint8", "1x2x3:uint7", "1x2x3:uint8:middle",
                          "1x2x3:uint8:skip=", "1x2x3:uint8:skip=-4", "1x2x99999999999:uint8"})
    EXPECT_FALSE(errorOf([&] { io::parseRawDescription(bad); }).empty()) << bad;
}

TEST(Raw, ReadsWhatTheDescriptionSays) {
  const fs::path path = scratchFolder() / "voxels.raw";
  writeFile(path, "skipped" + bytesOf(std::vector<std::int16_t>{-1, 2, 3, 400, 5, 6}, true));
  io::OpenOptions options;
  options.raw = io::parseRawDescription("3x2x1:int16:be:skip=7");
  options.raw->spacing = {1, 2, 3};
  const io::OpenedVolume opened = io::openVolume(path, options);
  EXPECT_EQ(realValues(*opened.volume), (std::vector<double>{-1, 2, 3, 400, 5, 6}));
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(1, 2, 3));
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Raw, SizesThatDisagreeAreSaidInFigures) {
  const fs::path path = scratchFolder() / "voxels.raw";
  writeFile(path, std::string(10, 'x'));
  io::OpenOptions options;
  options.raw = io::parseRawDescription("3x2x2:uint8");
  const std::string error = errorOf([&] { io::openVolume(path, options); });
  EXPECT_NE(error.find("10"), std::string::npos) << error;
  EXPECT_NE(error.find("12"), std::string::npos) << error;
  options.raw = io::parseRawDescription("3x3x1:uint8");
  const std::string warning = warningOf(io::openVolume(path, options).warnings, Warning::Kind::Other).text;
  EXPECT_NE(warning.find("10"), std::string::npos) << warning;
  EXPECT_NE(warning.find("9"), std::string::npos) << warning;
}

}  // namespace fenestra::tests
