#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::nrrdTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

std::vector<std::int16_t> counting(int count) {
  std::vector<std::int16_t> values;
  for (int i = 0; i < count; ++i) values.push_back(static_cast<std::int16_t>(i * 3 - 20));
  return values;
}

const std::string basics =
    "NRRD0004\n# a comment\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
    "space directions: (2,0,0) (0,3,0) (0,0,4)\nspace origin: (10,20,30)\nendian: little\n";

std::vector<double> expectedValues() {
  const auto values = counting(24);
  return {values.begin(), values.end()};
}

}  // namespace

TEST(Nrrd, ReadsEveryEncodingAttached) {
  const fs::path path = scratchFolder() / "image.nrrd";
  const std::string raw = bytesOf(counting(24));
  std::string text;
  for (const auto value : counting(24)) text += std::to_string(value) + (value % 2 ? "\n" : " ");
  const std::pair<const char*, std::string> encodings[] = {
      {"raw", raw},          {"gzip", gzipped(raw)}, {"gz", gzipped(raw)}, {"bzip2", bzipped(raw)},
      {"bz2", bzipped(raw)}, {"ascii", text},        {"text", text}};
  for (const auto& [encoding, data] : encodings) {
    SCOPED_TRACE(encoding);
    writeFile(path, basics + "encoding: " + encoding + "\n\n" + data);
    const io::OpenedVolume opened = io::openVolume(path);
    EXPECT_EQ(opened.format, "NRRD");
    EXPECT_EQ(realValues(*opened.volume), expectedValues());
    EXPECT_EQ(opened.volume->grid.origin, glm::dvec3(10, 20, 30));
    EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(2, 3, 4));
    EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  }
}

TEST(Nrrd, SkipsLinesAndBytesOfDetachedData) {
  const fs::path folder = scratchFolder();
  const std::string raw = bytesOf(counting(24));
  const std::string head = basics + "data file: image.dat\n";
  const auto expectRead = [&](const std::string& fields, const std::string& data) {
    SCOPED_TRACE(fields);
    writeFile(folder / "image.nhdr", head + fields);
    writeFile(folder / "image.dat", data);
    EXPECT_EQ(realValues(*io::openVolume(folder / "image.nhdr").volume), expectedValues());
  };
  expectRead("encoding: raw\n", raw);
  expectRead("encoding: raw\nbyte skip: 5\n", "12345" + raw);
  expectRead("encoding: raw\nbyte skip: -1\n", "anything" + raw);
  expectRead("encoding: raw\nline skip: 2\nbyte skip: 1\n", "one\ntwo\n3" + raw);
  expectRead("encoding: gzip\nline skip: 1\n", "one\n" + gzipped(raw));
  expectRead("encoding: gzip\nbyte skip: 3\n", gzipped("abc" + raw));
  expectRead("encoding: gzip\nbyteskip: -1\n", gzipped("whatever it is" + raw));
}

TEST(Nrrd, JoinsListedAndNumberedFiles) {
  const fs::path folder = scratchFolder();
  const std::string raw = bytesOf(counting(24));
  for (int i = 0; i < 4; ++i)
    writeFile(folder / ("s00" + std::to_string(7 - 2 * i) + ".raw"), raw.substr(static_cast<std::size_t>(12 * i), 12));
  writeFile(folder / "pattern.nhdr", basics + "encoding: raw\ndata file: s%03d.raw 7 1 -2\n");
  EXPECT_EQ(realValues(*io::openVolume(folder / "pattern.nhdr").volume), expectedValues());
  writeFile(folder / "list.nhdr",
            basics + "encoding: raw\ndata file: LIST 2\ns007.raw\ns005.raw\ns003.raw\ns001.raw\n");
  EXPECT_EQ(realValues(*io::openVolume(folder / "list.nhdr").volume), expectedValues());
  writeFile(folder / "short.nhdr", basics + "encoding: raw\ndata file: LIST\ns007.raw\ns005.raw\ns003.raw\n");
  EXPECT_FALSE(errorOf([&] { io::openVolume(folder / "short.nhdr"); }).empty());
  for (const char* pattern : {"s%s.raw", "s%03d%d.raw", "s%.raw", "s%99999d.raw", "s%n.raw"}) {
    writeFile(folder / "bad.nhdr", basics + "encoding: raw\ndata file: " + pattern + " 1 4 1\n");
    EXPECT_NE(errorOf([&] { io::openVolume(folder / "bad.nhdr"); }).find("pattern"), std::string::npos) << pattern;
  }
}

TEST(Nrrd, TurnsSpacesToLps) {
  const fs::path path = scratchFolder() / "image.nrrd";
  const auto cornerIn = [&](const std::string& space) {
    writeFile(path, "NRRD0005\ntype: uint8\ndimension: 3\nspace: " + space +
                        "\nsizes: 2 2 2\nspace directions: (1,0,0) (0,2,0) (0,1,3)\nspace origin: "
                        "(10,20,30)\nencoding: raw\n\n12345678");
    const io::OpenedVolume opened = io::openVolume(path);
    return opened.volume->grid.worldFromIndex() * glm::dvec4(1, 1, 1, 1);
  };
  const auto expectNear = [](const glm::dvec4& actual, const glm::dvec4& wanted) {
    EXPECT_NEAR(glm::distance(actual, wanted), 0.0, 1e-12);
  };
  expectNear(cornerIn("left-posterior-superior"), {11, 23, 33, 1});
  expectNear(cornerIn("LPS"), {11, 23, 33, 1});
  expectNear(cornerIn("right-anterior-superior"), {-11, -23, 33, 1});
  expectNear(cornerIn("left-anterior-superior"), {11, -23, 33, 1});
  expectNear(cornerIn("3D-left-handed"), {11, 23, -33, 1});
  warningOf(io::openVolume(path).warnings, Warning::Kind::NoGeometry);
}

TEST(Nrrd, AShearedLatticeStaysSheared) {
  const fs::path path = scratchFolder() / "image.nrrd";
  writeFile(path,
            "NRRD0005\ntype: uint8\ndimension: 3\nspace: LPS\nsizes: 1 1 2\nspace directions: (1,0,0) (0,1,0) "
            "(0,3,4)\nencoding: raw\n\n12");
  const Grid grid = io::openVolume(path).volume->grid;
  EXPECT_DOUBLE_EQ(grid.spacing.z, 5.0);
  EXPECT_NEAR(grid.direction[2].y, 0.6, 1e-15);
}

TEST(Nrrd, BigEndianAndSpacingsWithoutOrientation) {
  const fs::path path = scratchFolder() / "image.nrrd";
  writeFile(path, "NRRD0001\ntype: short\ndimension: 3\nsizes: 2 3 4\nspacings: 1 2 3\nendian: big\nencoding: raw\n\n" +
                      bytesOf(counting(24), true));
  const io::OpenedVolume opened = io::openVolume(path);
  EXPECT_EQ(realValues(*opened.volume), expectedValues());
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(1, 2, 3));
  warningOf(opened.warnings, Warning::Kind::NoGeometry);
}

TEST(Nrrd, ShowsTheFirstOfAListAndRefusesVectors) {
  const fs::path path = scratchFolder() / "image.nrrd";
  const std::string head = "NRRD0004\ntype: uchar\ndimension: 4\nspace: LPS\nencoding: raw\n";
  writeFile(
      path,
      head +
          "sizes: 2 2 1 1\nkinds: list domain domain domain\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n\nabcd");
  io::OpenedVolume opened = io::openVolume(path);
  EXPECT_EQ(realValues(*opened.volume), (std::vector<double>{'a', 'c'}));
  warningOf(opened.warnings, Warning::Kind::TimePoints);
  writeFile(
      path,
      head +
          "sizes: 2 1 1 2\nkinds: domain domain domain list\nspace directions: (1,0,0) (0,1,0) (0,0,1) none\n\nabcd");
  opened = io::openVolume(path);
  EXPECT_EQ(realValues(*opened.volume), (std::vector<double>{'a', 'b'}));
  writeFile(path, head +
                      "sizes: 3 2 1 1\nkinds: RGB-color domain domain domain\nspace directions: none (1,0,0) (0,1,0) "
                      "(0,0,1)\n\nabcdef");
  EXPECT_NE(errorOf([&] { io::openVolume(path); }).find("rgb-color"), std::string::npos);
}

}  // namespace fenestra::tests::nrrdTest
