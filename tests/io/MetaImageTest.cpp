#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::metaImageTest {
namespace fs = std::filesystem;

namespace {

const std::string basics =
    "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 2 3 4\nOffset = 10 20 30\n";

std::vector<std::uint16_t> counting() {
  std::vector<std::uint16_t> values;
  for (int i = 0; i < 24; ++i) values.push_back(static_cast<std::uint16_t>(i * 500));
  return values;
}
std::vector<double> expectedValues() {
  const auto values = counting();
  return {values.begin(), values.end()};
}

}  // namespace

TEST(MetaImage, ReadsLocalAndSeparateDataPackedAndPlain) {
  const fs::path folder = scratchFolder();
  const std::string raw = bytesOf(counting()), packed = zlibbed(raw);
  const auto expectRead = [&](const std::string& fields, const std::string& localData) {
    SCOPED_TRACE(fields);
    writeFile(folder / "image.mha", basics + "ElementType = MET_USHORT\n" + fields + localData);
    const io::OpenedVolume opened = io::openVolume(folder / "image.mha");
    EXPECT_EQ(opened.format, "MetaImage");
    EXPECT_EQ(realValues(*opened.volume), expectedValues());
    EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(2, 3, 4));
    EXPECT_EQ(opened.volume->grid.origin, glm::dvec3(10, 20, 30));
    EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  };
  expectRead("ElementDataFile = LOCAL\n", raw);
  expectRead(
      "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\nElementDataFile = LOCAL\n",
      packed);
  expectRead("BinaryDataByteOrderMSB = True\nElementDataFile = Local\n", bytesOf(counting(), true));
  std::string text;
  for (const auto value : counting()) text += std::to_string(value) + " ";
  expectRead("BinaryData = False\nElementDataFile = LOCAL\n", text);
  writeFile(folder / "a.raw", "head" + raw);
  expectRead("HeaderSize = 4\nElementDataFile = a.raw\n", "");
  expectRead("HeaderSize = -1\nElementDataFile = a.raw\n", "");
  for (int i = 0; i < 4; ++i)
    writeFile(folder / std::to_string(i + 1).append(".raw"), raw.substr(static_cast<std::size_t>(12 * i), 12));
  expectRead("ElementDataFile = %d.raw 1 4 1\n", "");
  expectRead("ElementDataFile = LIST\n1.raw\n2.raw\n3.raw\n4.raw\n", "");
}

TEST(MetaImage, TransformMatrixListsTheAxes) {
  const fs::path path = scratchFolder() / "image.mha";
  writeFile(path, basics +
                      "TransformMatrix = 0 1 0 0 0 -1 -1 0 0\nElementType = MET_USHORT\nElementDataFile = LOCAL\n" +
                      bytesOf(counting()));
  const glm::dmat4 world = io::openVolume(path).volume->grid.worldFromIndex();
  EXPECT_EQ(world * glm::dvec4(1, 0, 0, 1), glm::dvec4(10, 22, 30, 1));
  EXPECT_EQ(world * glm::dvec4(0, 1, 0, 1), glm::dvec4(10, 20, 27, 1));
  EXPECT_EQ(world * glm::dvec4(0, 0, 1, 1), glm::dvec4(6, 20, 30, 1));
}

TEST(MetaImage, ChannelsAreRefused) {
  const fs::path path = scratchFolder() / "image.mha";
  writeFile(path, basics + "ElementNumberOfChannels = 3\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                      std::string(72, 'x'));
  EXPECT_NE(errorOf([&] { io::openVolume(path); }).find("3 values"), std::string::npos);
}

TEST(MetaImage, ModalityNamesTheUnit) {
  const fs::path path = scratchFolder() / "image.mha";
  writeFile(path, basics + "Modality = MET_MOD_CT\nElementType = MET_USHORT\nElementDataFile = LOCAL\n" +
                      bytesOf(counting()));
  EXPECT_EQ(io::openVolume(path).volume->modality, Modality::CT);
  EXPECT_EQ(io::openVolume(path).volume->unit, "HU");
}

}  // namespace fenestra::tests::metaImageTest
