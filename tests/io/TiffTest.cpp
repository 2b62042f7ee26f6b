// Stacks of TIFF pages: every kind of numbers, packing and order, from files and folders.

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "io/base/NaturalOrder.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/io/TiffFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::tiffTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

const io::OpenOptions told{.spacing = glm::dvec3(0.01, 0.01, 0.02)};

/// The first value of each slice, which tells the order of pages of 2 x 3.
std::vector<int> firsts(const io::OpenedVolume& opened) {
  std::vector<int> result;
  const std::vector<double> values = realValues(*opened.volume);
  for (std::size_t i = 0; i < values.size(); i += 6) result.push_back(static_cast<int>(values[i]) / 6);
  return result;
}

}  // namespace

TEST(Tiff, EveryKindOfNumberPackingAndOrderHasItsValues) {
  const fs::path path = scratchFolder() / "a.tif";
  std::vector<TiffSpec> specs;
  for (const char* mode : {"wl", "wb", "wl8", "wb8"})
    for (const int compression : {1, 5, 8, 32773})
      for (const bool tiled : {false, true})
        for (const auto& [bits, format] : {std::pair(8, 1), std::pair(8, 2), std::pair(16, 1), std::pair(16, 2),
                                           std::pair(32, 1), std::pair(32, 3), std::pair(64, 3)}) {
          TiffSpec spec{.width = 19, .height = 17, .pages = 3, .bits = bits, .sampleFormat = format};
          spec.compression = compression;
          spec.tiled = tiled;
          spec.mode = mode;
          if (bits == 8)
            spec = {.width = 5,
                    .height = 4,
                    .pages = 3,
                    .bits = 8,
                    .sampleFormat = format,
                    .compression = compression,
                    .tiled = tiled,
                    .mode = mode};
          specs.push_back(spec);
        }
  for (const TiffSpec& spec : specs) {
    SCOPED_TRACE(spec.mode + " " + std::to_string(spec.bits) + " " + std::to_string(spec.sampleFormat) + " " +
                 std::to_string(spec.compression) + (spec.tiled ? " tiles" : " strips"));
    writeTiff(path, spec);
    const io::OpenedVolume opened = io::openVolume(path, told);
    EXPECT_EQ(opened.format, "TIFF");
    EXPECT_EQ(opened.volume->grid.dims, glm::ivec3(spec.width, spec.height, spec.pages));
    EXPECT_EQ(opened.volume->grid.spacing, *told.spacing);
    EXPECT_EQ(realValues(*opened.volume), tiffValues(spec));
  }
}

TEST(Tiff, AFolderIsAStackInTheNaturalOrderOfItsNames) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 12; ++i)
    writeTiff(folder / ("slice" + std::to_string(i) + (i % 2 ? ".tif" : ".tiff")), {.pages = 1, .first = 6 * i});
  // Half of them have another ending.
  for (int i = 0; i < 12; i += 2)
    fs::rename(folder / ("slice" + std::to_string(i) + ".tiff"), folder / ("slice" + std::to_string(i) + ".tif"));
  const io::OpenedVolume opened = io::openVolume(folder, told);
  EXPECT_EQ(firsts(opened), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(opened.series.files.size(), 12u);
  EXPECT_EQ(opened.warnings.size(), 1u) << kindsOf(opened.warnings);
  fs::remove(folder / "slice5.tif");
  const Warning gap = warningOf(io::openVolume(folder, told).warnings, Warning::Kind::MissingSlices);
  EXPECT_NE(gap.text.find("have 1 gap (slice4.tif is followed by slice6.tif)"), std::string::npos) << gap.text;
}

TEST(Tiff, NamesSortAsPeopleNumberThem) {
  EXPECT_TRUE(io::isBeforeNaturally("slice2", "slice10"));
  EXPECT_FALSE(io::isBeforeNaturally("slice10", "slice2"));
  EXPECT_TRUE(io::isBeforeNaturally("a002b", "a10a"));
  EXPECT_TRUE(io::isBeforeNaturally("a9", "a99999999999999999999999999"));
  EXPECT_TRUE(io::isBeforeNaturally("a", "a0"));
  EXPECT_TRUE(io::isBeforeNaturally("a01", "a1")) << "a fixed order";
  EXPECT_FALSE(io::isBeforeNaturally("a1", "a01"));
  EXPECT_FALSE(io::isBeforeNaturally("a1", "a1"));
}

TEST(Tiff, ChannelsAndTimesOfImageJAndOmeAreVolumes) {
  const fs::path path = scratchFolder() / "a.tif";
  // Pages: channels first, then slices, then times.
  writeTiff(path, {.pages = 12,
                   .description =
                       "ImageJ=1.53t\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\nunit=mm\nspacing=2\n",
                   .resolution = 4.0});
  const auto volumeAt = [&](int time) {
    io::OpenOptions options;
    options.time = time;
    return io::openVolume(path, options);
  };
  EXPECT_EQ(firsts(volumeAt(1)), (std::vector<int>{0, 2, 4}));
  EXPECT_EQ(firsts(volumeAt(2)), (std::vector<int>{1, 3, 5}));
  EXPECT_EQ(firsts(volumeAt(4)), (std::vector<int>{7, 9, 11}));
  EXPECT_EQ(volumeAt(1).volume->grid.spacing, glm::dvec3(0.25, 0.25, 2.0));
  writeTiff(path,
            {.pages = 6,
             .description = "<?xml version=\"1.0\"?><OME><Image><Pixels DimensionOrder=\"XYZCT\" SizeX=\"2\" "
                            "SizeY=\"3\" SizeZ=\"3\" SizeC=\"2\" SizeT=\"1\" PhysicalSizeX=\"10\" PhysicalSizeY=\"20\" "
                            "PhysicalSizeZ=\"0.5\" PhysicalSizeZUnit=\"mm\"/></Image></OME>"});
  EXPECT_EQ(firsts(volumeAt(1)), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(firsts(volumeAt(2)), (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(volumeAt(1).volume->grid.spacing, glm::dvec3(0.01, 0.02, 0.5));
}

TEST(Tiff, FilesOfSeveralPagesAreVolumesOfTheirOwn) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 3; ++i) writeTiff(folder / ("time" + std::to_string(i) + ".tif"), {.pages = 4, .first = 24 * i});
  io::OpenOptions options = told;
  EXPECT_EQ(firsts(io::openVolume(folder, options)), (std::vector<int>{0, 1, 2, 3}));
  options.time = 3;
  EXPECT_EQ(firsts(io::openVolume(folder, options)), (std::vector<int>{8, 9, 10, 11}));
}

TEST(Tiff, ImageJsLargeStacksHaveOnePageAndTheOthersBehindIt) {
  const fs::path path = scratchFolder() / "a.tif";
  writeTiff(path, {.pages = 1,
                   .mode = "wb",
                   .description = "ImageJ=1.53t\nimages=3\nslices=3\nunit=um\nspacing=5\n",
                   .resolution = 0.5});
  // libtiff writes the pixels first, and the other pages' pixels belong behind them: the file is made anew around them.
  std::string bytes = readFile(path), pixels;
  for (int i = 0; i < 18; ++i) pixels += bytesOf(static_cast<std::int16_t>(i), true);
  const std::size_t strips = bytes.find(pixels.substr(0, 12));
  ASSERT_NE(strips, std::string::npos);
  const std::size_t end = bytes.size() + bytes.size() % 2;
  bytes.resize(end, '\0');
  bytes += pixels;
  // One strip of the whole page at the end: tags 273 (offsets), 278 (rows) and 279 (counts).
  const auto directory =
      static_cast<std::size_t>(static_cast<unsigned char>(bytes[6])) * 256 + static_cast<unsigned char>(bytes[7]);
  const int entries =
      static_cast<unsigned char>(bytes[directory]) * 256 + static_cast<unsigned char>(bytes[directory + 1]);
  for (int i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * static_cast<std::size_t>(i);
    const int tag = static_cast<unsigned char>(bytes[at]) * 256 + static_cast<unsigned char>(bytes[at + 1]);
    const auto set = [&](std::uint32_t value) {
      bytes.replace(at + 2, 2, bytesOf(std::uint16_t{4}, true));
      bytes.replace(at + 4, 8, bytesOf(std::uint32_t{1}, true) + bytesOf(value, true));
    };
    if (tag == 273) set(static_cast<std::uint32_t>(end));
    if (tag == 278) set(3);
    if (tag == 279) set(12);
  }
  writeFile(path, bytes);
  const io::OpenedVolume opened = io::openVolume(path);
  EXPECT_EQ(firsts(opened), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(0.002, 0.002, 0.005));
}

TEST(Tiff, WhiteThatIsZeroIsTurnedRoundAndPalettesAreNumbers) {
  const fs::path path = scratchFolder() / "a.tif";
  TiffSpec spec{.pages = 1, .bits = 8, .photometric = 0};
  writeTiff(path, spec);
  EXPECT_EQ(realValues(*io::openVolume(path, told).volume), (std::vector<double>{255, 254, 253, 252, 251, 250}));
  spec.photometric = 3;
  writeTiff(path, spec);
  EXPECT_EQ(realValues(*io::openVolume(path, told).volume), (std::vector<double>{0, 1, 2, 3, 4, 5}));
}

TEST(Tiff, ALabelStackOfTheVolumesSizeLiesOnIt) {
  const fs::path path = scratchFolder() / "labels.tif";
  writeTiff(path, {.pages = 4, .bits = 8});
  const io::OpenedLabels opened = io::openLabels(path, labelGrid({2, 3, 4}, glm::dvec3(5), glm::dvec3(0.3)));
  std::vector<int> expected;
  for (int i = 0; i < 24; ++i) expected.push_back(i);
  EXPECT_EQ(valuesOf(*opened.labels), expected);
  EXPECT_EQ(opened.labels->grid.spacing, glm::dvec3(0.3));
  EXPECT_NE(errorOf([&] {
              io::openLabels(path, labelGrid({2, 3, 5}));
            }).find("where the volume has 2 x 3 x 5"),
            std::string::npos);
}

TEST(Tiff, AStackWithoutASizeOfVoxelsAsksForIt) {
  const fs::path folder = scratchFolder(), path = folder / "a.tif";
  writeTiff(path, {});
  EXPECT_THROW(io::openVolume(path), io::SpacingMissing);
  EXPECT_EQ(io::listSeries(path).size(), 1u);
  EXPECT_EQ(io::openVolume(path, told).volume->grid.spacing, *told.spacing);
}

}  // namespace fenestra::tests::tiffTest
