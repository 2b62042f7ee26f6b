#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::dicomTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

/// A series of slices at the positions given; each holds one value, `slice · 10`. Names and instance numbers sort in
/// another order.
void writeSeries(const fs::path& folder, const std::vector<glm::dvec3>& positions, DicomSpec spec = {}) {
  fs::create_directories(folder);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    spec.instance = "1.2.3." + spec.series + "." + std::to_string(i + 1);
    spec.instanceNumber = static_cast<int>((i * 7 + 3) % positions.size()) + 1;
    spec.position = positions[i];
    spec.words.assign(static_cast<std::size_t>(spec.rows * spec.columns), static_cast<std::uint32_t>(i * 10));
    writeDicom(folder / ("s" + std::to_string((i * 5 + 2) % positions.size()) + "-" + std::to_string(i)), spec);
  }
}

std::vector<glm::dvec3> along(const glm::dvec3& step, int count) {
  std::vector<glm::dvec3> positions;
  for (int i = 0; i < count; ++i) positions.push_back(glm::dvec3(-10, 20, 30) + step * static_cast<double>(i));
  return positions;
}

/// The value of each slice's first voxel.
std::vector<double> sliceValues(const Volume& volume) {
  std::vector<double> values;
  for (int z = 0; z < volume.grid.dims.z; ++z) values.push_back(volume.value({0, 0, z}));
  return values;
}

}  // namespace

TEST(Dicom, OrdersSlicesByPosition) {
  const fs::path folder = scratchFolder();
  writeSeries(folder, along({0, 0, -2.5}, 7));
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.format, "DICOM");
  EXPECT_EQ(opened.volume->grid.dims, glm::ivec3(4, 3, 7));
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{60, 50, 40, 30, 20, 10, 0}));
  EXPECT_EQ(opened.volume->grid.origin, glm::dvec3(-10, 20, 15));
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(1, 1, 2.5));
  EXPECT_EQ(opened.volume->grid.direction, glm::dmat3(1.0));
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  EXPECT_EQ(opened.volume->modality, Modality::CT);
  EXPECT_EQ(opened.volume->unit, "HU");
}

TEST(Dicom, KeepsObliqueGeometry) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.row = glm::normalize(glm::dvec3(0, 1, 0.2));
  spec.column = glm::normalize(glm::cross(glm::normalize(glm::dvec3(1, 0.3, 0)), spec.row));
  spec.column = glm::normalize(spec.column - glm::dot(spec.column, spec.row) * spec.row);
  spec.pixelSpacing = "0.5\\0.75";
  const glm::dvec3 normal = glm::cross(spec.row, spec.column);
  writeSeries(folder, along(normal * 3.0, 5), spec);
  const io::OpenedVolume opened = io::openVolume(folder);
  Grid expected;
  expected.dims = {4, 3, 5};
  expected.origin = {-10, 20, 30};
  expected.spacing = {0.75, 0.5, 3.0};
  expected.direction = glm::dmat3(spec.row, spec.column, normal);
  // A decimal string of 16 characters keeps about 13 digits.
  expectSameGrid(opened.volume->grid, expected, 1e-9);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Dicom, GantryTiltShearsTheGridAndIsSaid) {
  const fs::path folder = scratchFolder();
  const double tilt = 15.0 * std::numbers::pi / 180.0;
  DicomSpec spec;
  spec.column = {0, std::cos(tilt), -std::sin(tilt)};
  writeSeries(folder, along({0, 0, 2}, 6), spec);
  const io::OpenedVolume opened = io::openVolume(folder);
  const Grid& grid = opened.volume->grid;
  EXPECT_NEAR(glm::distance(grid.direction[2], glm::dvec3(0, 0, 1)), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(grid.spacing.z, 2.0);
  EXPECT_NEAR(grid.voxelVolume(), 2.0 * std::cos(tilt), 1e-9);
  const Warning warning = warningOf(opened.warnings, Warning::Kind::GantryTilt);
  EXPECT_NE(warning.text.find("15 degrees"), std::string::npos) << warning.text;
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::SlicePlacement).text.find("sheared"), std::string::npos);
  EXPECT_EQ(opened.warnings.size(), 2u) << kindsOf(opened.warnings);
}

TEST(Dicom, RoundingBelowAHundredthOfAMillimetreIsSilent) {
  const fs::path folder = scratchFolder();
  std::vector<glm::dvec3> positions = along({0, 0, 2}, 6);
  positions[2].z += 0.004;
  positions[3].x -= 0.004;
  writeSeries(folder, positions);
  EXPECT_TRUE(io::openVolume(folder).warnings.empty());
}

TEST(Dicom, MissingSlicesAreCountedAndTheirNeighboursNamed) {
  const fs::path folder = scratchFolder();
  std::vector<glm::dvec3> positions = along({0, 0, 2}, 8);
  positions.erase(positions.begin() + 3, positions.begin() + 5);
  writeSeries(folder, positions);
  const io::OpenedVolume opened = io::openVolume(folder);
  const Warning warning = warningOf(opened.warnings, Warning::Kind::MissingSlices);
  EXPECT_NE(warning.text.find("2 slices missing"), std::string::npos) << warning.text;
  EXPECT_EQ(warning.files.size(), 2u);
  EXPECT_EQ(opened.volume->grid.origin.z, 30.0);
  EXPECT_DOUBLE_EQ(opened.volume->grid.spacing.z, 2.0);
  // 20 and 30 lie three steps apart.
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{0, 10, 20, 23, 27, 30, 40, 50}));
  // As stored, both ends lie where the file says; the slices between are evenly spread.
  const auto spread = io::openVolume(folder, {.regularise = io::Regularise::Off}).volume;
  EXPECT_EQ(spread->grid.origin.z, 30.0);
  EXPECT_DOUBLE_EQ(spread->grid.origin.z + spread->grid.spacing.z * 5, 44.0);
}

TEST(Dicom, UnevenSpacingIsSaidWithFigures) {
  const fs::path folder = scratchFolder();
  writeSeries(folder, {{0, 0, 0}, {0, 0, 1}, {0, 0, 2.3}, {0, 0, 4}, {0, 0, 5.5}});
  const io::OpenedVolume opened = io::openVolume(folder);
  const Warning warning = warningOf(opened.warnings, Warning::Kind::UnevenSpacing);
  EXPECT_NE(warning.text.find("between 1 mm and 1.7 mm"), std::string::npos) << warning.text;
  const Warning placement = warningOf(opened.warnings, Warning::Kind::SlicePlacement);
  EXPECT_NE(placement.text.find("5 planes 1.375 mm apart"), std::string::npos) << placement.text;
}

TEST(Dicom, ASliceFarFromTheOthersIsAVolumeOfItsOwn) {
  const fs::path folder = scratchFolder();
  writeSeries(folder, {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 200}});
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims.z, 4);
  ASSERT_EQ(opened.otherSeries.size(), 1u);
  EXPECT_EQ(opened.otherSeries[0].dims.z, 1);
  EXPECT_EQ(opened.otherSeries[0].id, opened.series.id + "#2");
  EXPECT_EQ(warningOf(opened.warnings, Warning::Kind::MissingSlices).files.size(), 1u);
  const io::OpenedVolume other = io::openVolume(folder, {.series = opened.otherSeries[0].id});
  EXPECT_EQ(other.volume->grid.origin.z, 200.0);
}

TEST(Dicom, DuplicatePositionsAreLeftOutAndNamed) {
  const fs::path folder = scratchFolder();
  writeSeries(folder, {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}});
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims.z, 4);
  EXPECT_EQ(warningOf(opened.warnings, Warning::Kind::DuplicateSlices).files.size(), 1u);
}

TEST(Dicom, CopiesOfAFileAreLeftOutAndNamed) {
  const fs::path folder = scratchFolder();
  writeSeries(folder, along({0, 0, 1}, 4));
  fs::copy_file(folder / "s2-0", folder / "copy");
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims.z, 4);
  EXPECT_EQ(warningOf(opened.warnings, Warning::Kind::DuplicateSlices).files.size(), 1u);
}

TEST(Dicom, RepeatsAtEveryPositionAreTimePoints) {
  const fs::path folder = scratchFolder();
  for (int time = 0; time < 3; ++time)
    for (int z = 0; z < 4; ++z) {
      DicomSpec spec;
      spec.instance = "1.2." + std::to_string(time * 10 + z + 1);
      spec.acquisitionNumber = 3 - time;
      spec.position = glm::dvec3(0, 0, z);
      spec.words.assign(12, static_cast<std::uint32_t>(100 * (3 - time) + z));
      writeDicom(folder / spec.instance, spec);
    }
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{100, 101, 102, 103}));
  EXPECT_EQ(opened.otherSeries.size(), 2u);
  warningOf(opened.warnings, Warning::Kind::TimePoints);
  EXPECT_EQ(sliceValues(*io::openVolume(folder, {.series = "1.2.3.4#3"}).volume),
            (std::vector<double>{300, 301, 302, 303}));
}

TEST(Dicom, MixedSizesAndOrientationsFormVolumesOfTheirOwn) {
  const fs::path folder = scratchFolder();
  writeSeries(folder, along({0, 0, 1}, 5));
  DicomSpec wide;
  wide.columns = 5;
  wide.instance = "9.1";
  wide.words.assign(15, 7);
  wide.position = glm::dvec3(-10, 20, 32.5);
  writeDicom(folder / "wide", wide);
  DicomSpec turned;
  turned.row = {0, 1, 0};
  turned.column = {0, 0, -1};
  turned.instance = "9.2";
  turned.words.assign(12, 8);
  writeDicom(folder / "turned", turned);
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims, glm::ivec3(4, 3, 5));
  EXPECT_EQ(opened.otherSeries.size(), 2u);
  EXPECT_EQ(warningOf(opened.warnings, Warning::Kind::MixedSizes).files, std::vector<fs::path>{folder / "wide"});
  EXPECT_EQ(warningOf(opened.warnings, Warning::Kind::MixedOrientations).files,
            std::vector<fs::path>{folder / "turned"});
}

TEST(Dicom, SeriesAreToldApartAndEmptyIdentifiersGroup) {
  const fs::path folder = scratchFolder();
  DicomSpec other;
  other.series = "9.9";
  other.description = "Größe × 2";
  writeSeries(folder / "a", along({0, 0, 1}, 3), other);
  DicomSpec unnamed;
  unnamed.series = "";
  for (int z = 0; z < 4; ++z) {
    unnamed.instance = "";
    unnamed.position = glm::dvec3(0, 0, z);
    writeDicom(folder / std::to_string(z), unnamed);
  }
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.series.id, "no-uid");
  EXPECT_EQ(opened.series.dims.z, 4);
  ASSERT_EQ(opened.otherSeries.size(), 1u);
  EXPECT_EQ(opened.otherSeries[0].description, "Größe × 2");
  EXPECT_EQ(io::listSeries(folder).size(), 2u);
  EXPECT_EQ(io::openVolume(folder, {.series = "9.9"}).volume->grid.dims.z, 3);
  EXPECT_NE(errorOf([&] { io::openVolume(folder, {.series = "7"}); }).find("no series 7"), std::string::npos);
}

struct Bits {
  int allocated, stored, highBit;
  bool isSigned;
};

class DicomBits : public ::testing::TestWithParam<Bits> {};

TEST_P(DicomBits, AreTakenOutOfTheWordWhateverSurroundsThem) {
  const auto [allocated, stored, highBit, isSigned] = GetParam();
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.bitsAllocated = allocated;
  spec.bitsStored = stored;
  spec.highBit = highBit;
  spec.isSigned = isSigned;
  const std::int64_t span = std::int64_t{1} << stored, least = isSigned ? -span / 2 : 0;
  std::vector<double> expected;
  for (int i = 0; i < 12; ++i) {
    const std::int64_t value = i == 11 ? least + span - 1 : least + span / 12 * i;
    const auto garbage = static_cast<std::uint64_t>(i % 2 ? 0xffffffffu : 0x5a5a5a5au);
    const int shift = highBit + 1 - stored;
    const std::uint64_t mask = ((std::uint64_t{1} << stored) - 1) << shift;
    const std::uint64_t word = (garbage & ~mask) | ((static_cast<std::uint64_t>(value) << shift) & mask);
    spec.words.push_back(static_cast<std::uint32_t>(word & ((std::uint64_t{1} << allocated) - 1)));
    expected.push_back(static_cast<double>(value));
  }
  writeDicom(folder / "image", spec);
  const io::OpenedVolume opened = io::openVolume(folder / "image");
  EXPECT_EQ(realValues(*opened.volume), expected);
}

INSTANTIATE_TEST_SUITE_P(All, DicomBits,
                         ::testing::Values(Bits{8, 8, 7, false}, Bits{8, 8, 7, true}, Bits{8, 5, 6, false},
                                           Bits{16, 8, 7, true}, Bits{16, 10, 9, false}, Bits{16, 12, 11, false},
                                           Bits{16, 12, 11, true}, Bits{16, 12, 15, true}, Bits{16, 12, 13, false},
                                           Bits{16, 16, 15, false}, Bits{16, 16, 15, true}, Bits{32, 32, 31, false},
                                           Bits{32, 32, 31, true}, Bits{32, 24, 27, true}));

class DicomSyntax : public ::testing::TestWithParam<Syntax> {};

TEST_P(DicomSyntax, DecodesToTheSameValues) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.syntax = GetParam();
  spec.columns = 37;
  spec.rows = 23;
  spec.isSigned = false;
  spec.bitsStored = 12;
  spec.highBit = 11;
  std::vector<double> expected;
  for (int i = 0; i < spec.columns * spec.rows; ++i) {
    spec.words.push_back(static_cast<std::uint32_t>((i * i) % 4096));
    expected.push_back((i * i) % 4096);
  }
  writeDicom(folder / "image", spec);
  EXPECT_EQ(realValues(*io::openVolume(folder / "image").volume), expected);
}

INSTANTIATE_TEST_SUITE_P(All, DicomSyntax,
                         ::testing::Values(Syntax::ImplicitLittle, Syntax::ExplicitLittle, Syntax::ExplicitBig,
                                           Syntax::Deflated, Syntax::Rle, Syntax::JpegLossless, Syntax::JpegLs));

TEST(Dicom, OddEightBitFramesDecodeInEitherByteOrder) {
  for (const Syntax syntax : {Syntax::ExplicitLittle, Syntax::ExplicitBig}) {
    const fs::path folder = scratchFolder();
    DicomSpec spec;
    spec.syntax = syntax;
    spec.bitsAllocated = spec.bitsStored = 8;
    spec.highBit = 7;
    spec.isSigned = false;
    spec.columns = 3;
    spec.rows = 3;
    spec.frames = {{{0, 0, 0}}, {{0, 0, 1}}, {{0, 0, 2}}};
    writeDicom(folder / "image", spec);
    std::vector<double> expected(27);
    std::iota(expected.begin(), expected.end(), 0.0);
    EXPECT_EQ(realValues(*io::openVolume(folder / "image").volume), expected);
  }
}

TEST(Dicom, OneRescaleForAllIsKeptBesideTheStoredValues) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.slope = "0.5";
  spec.intercept = "-1024";
  spec.window = "40 400";
  writeSeries(folder, along({0, 0, 1}, 3), spec);
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->slope, 0.5);
  EXPECT_EQ(opened.volume->intercept, -1024.0);
  EXPECT_EQ(opened.volume->voxels.type(), ScalarType::UInt8);  // 0, 10, 20
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{-1024, -1019, -1014}));
  EXPECT_EQ(opened.volume->range, (ValueRange{-1024, -1014}));
  EXPECT_EQ(opened.volume->windows, (std::vector<WindowLevel>{{400, 40}}));
}

TEST(Dicom, WholeRescalesThatDifferStayIntegers) {
  const fs::path folder = scratchFolder();
  for (int z = 0; z < 3; ++z) {
    DicomSpec spec;
    spec.instance = "1.2." + std::to_string(z + 1);
    spec.position = glm::dvec3(0, 0, z);
    spec.slope = std::to_string(z + 1);
    spec.intercept = std::to_string(-100 * z);
    spec.words.assign(12, 50);
    writeDicom(folder / std::to_string(z), spec);
  }
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{50, 0, -50}));
  EXPECT_EQ(opened.volume->voxels.type(), ScalarType::Int8);
}

TEST(Dicom, FractionalRescalesThatDifferBecomeFloats) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.frames = {{{0, 0, 1}, 0.25, 3.5}, {{0, 0, 0}, 1.5, -7.0}};
  writeDicom(folder / "image", spec);
  const io::OpenedVolume opened = io::openVolume(folder / "image");
  EXPECT_EQ(opened.volume->voxels.type(), ScalarType::Float32);
  EXPECT_EQ(opened.volume->value({1, 0, 0}), 1.5 * 13 - 7.0);
  EXPECT_EQ(opened.volume->value({1, 0, 1}), 0.25 * 1 + 3.5);
}

TEST(Dicom, EnhancedFramesAreOrderedByPositionAndSplitByType) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.pixelSpacing = "2\\3";
  spec.frames = {
      {{0, 0, 4}}, {{0, 0, 0}}, {{0, 0, 2}}, {{0, 0, 0}, 2.0, 5.0, "DERIVED"}, {{0, 0, 2}, 2.0, 5.0, "DERIVED"}};
  writeDicom(folder / "image", spec);
  const io::OpenedVolume opened = io::openVolume(folder / "image");
  EXPECT_EQ(opened.volume->grid.dims, glm::ivec3(4, 3, 3));
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(3, 2, 2));
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{12, 24, 0}));
  ASSERT_EQ(opened.otherSeries.size(), 1u);
  const io::OpenedVolume derived = io::openVolume(folder / "image", {.series = opened.otherSeries[0].id});
  EXPECT_EQ(sliceValues(*derived.volume), (std::vector<double>{36 * 2 + 5, 48 * 2 + 5}));
}

TEST(Dicom, FramesWithoutPositionsAreAStackWithoutGeometry) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.numberOfFrames = 5;
  spec.position.reset();
  writeDicom(folder / "image", spec);
  const io::OpenedVolume opened = io::openVolume(folder / "image");
  EXPECT_EQ(opened.volume->grid.dims.z, 5);
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{0, 12, 24, 36, 48}));
  warningOf(opened.warnings, Warning::Kind::NoGeometry);
}

TEST(Dicom, DoseFramesLieAtTheirOffsets) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.sopClass = "1.2.840.10008.5.1.4.1.1.481.2";
  spec.modality = "RTDOSE";
  spec.bitsAllocated = spec.bitsStored = 32;
  spec.highBit = 31;
  spec.isSigned = false;
  spec.numberOfFrames = 3;
  spec.doseScaling = "0.001";
  spec.frameOffsets = "0\\2.5\\5";
  spec.position = glm::dvec3(5, 6, 7);
  writeDicom(folder / "dose", spec);
  const io::OpenedVolume opened = io::openVolume(folder / "dose");
  EXPECT_EQ(opened.volume->grid.origin, glm::dvec3(5, 6, 7));
  EXPECT_EQ(opened.volume->grid.spacing.z, 2.5);
  EXPECT_EQ(opened.volume->value({0, 0, 2}), 24 * 0.001);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Dicom, Monochrome1KeepsItsValuesAndIsShownInverted) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.photometric = "MONOCHROME1";
  writeDicom(folder / "image", spec);
  const io::OpenedVolume opened = io::openVolume(folder / "image");
  EXPECT_EQ(opened.volume->value({3, 0, 0}), 3.0);
  EXPECT_TRUE(opened.volume->lowIsWhite);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST(Dicom, ColoursAreRefused) {
  const fs::path folder = scratchFolder();
  DicomSpec spec;
  spec.photometric = "RGB";
  spec.samplesPerPixel = 3;
  spec.bitsAllocated = spec.bitsStored = 8;
  spec.highBit = 7;
  spec.isSigned = false;
  writeDicom(folder / "image", spec);
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "image"); }).find("RGB"), std::string::npos);
  EXPECT_NE(errorOf([&] { io::openVolume(folder); }).find("RGB"), std::string::npos);
}

TEST(Dicom, UnreadableFilesAreNamedAndTheRestLoads) {
  const fs::path folder = scratchFolder() / "Ordner ünïcødé 患者";
  writeSeries(folder, along({0, 0, 1}, 6));
  const auto lastOf = [&](const char* ending) {
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().string().ends_with(ending)) return entry.path();
    return fs::path();
  };
  const fs::path cut = lastOf("-3"), headless = lastOf("-1");
  fs::resize_file(cut, fs::file_size(cut) - 10);
  fs::resize_file(headless, 300);
  writeFile(folder / "notes.txt", "not an image");
  const io::OpenedVolume opened = io::openVolume(folder);
  // The places of the lost ones are filled from their neighbours.
  EXPECT_EQ(sliceValues(*opened.volume), (std::vector<double>{0, 10, 20, 30, 40, 50}));
  std::vector<fs::path> named;
  for (const Warning& warning : opened.warnings)
    if (warning.kind == Warning::Kind::UnreadableFiles)
      named.insert(named.end(), warning.files.begin(), warning.files.end());
  std::sort(named.begin(), named.end());
  std::vector<fs::path> expected{cut, headless, folder / "notes.txt"};
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(named, expected);
  warningOf(opened.warnings, Warning::Kind::MissingSlices);
}

TEST(Dicom, FoldersWithoutImagesAreErrors) {
  const fs::path folder = scratchFolder();
  EXPECT_NE(errorOf([&] { io::openVolume(folder); }).find("empty folder"), std::string::npos);
  writeFile(folder / "notes.txt", "not an image");
  EXPECT_NE(errorOf([&] { io::openVolume(folder); }).find("no DICOM images"), std::string::npos);
}

TEST(Dicom, ADicomdirNamesTheFilesToOpen) {
  const fs::path folder = scratchFolder();
  writeSeries(folder / "IMAGES" / "A", along({0, 0, 1}, 3));
  writeFile(folder / "IMAGES" / "other.dcm", "not on the list, and not DICOM");
  // As copied by a system that changes case, with a file that was lost and one that points elsewhere.
  writeDicomDir(folder / "DICOMDIR", {{"images\\a\\S2-0"},
                                      {"images\\a\\S1-1"},
                                      {"images\\a\\S0-2", false},
                                      {"images\\a\\S2-9"},
                                      {"..\\..\\etc\\passwd"}});

  const io::OpenedVolume opened = io::openVolume(folder / "DICOMDIR");
  EXPECT_EQ(opened.volume->grid.dims.z, 2);
  const io::Warning missing = warningOf(opened.warnings, io::Warning::Kind::UnreadableFiles);
  EXPECT_EQ(missing.text, "2 files listed in the DICOMDIR missing");
  ASSERT_EQ(missing.files.size(), 2u);
  EXPECT_EQ(missing.files[0].filename(), "S2-9");
}

TEST(Dicom, ADicomdirWithoutRecordsStandsForItsFolder) {
  const fs::path folder = scratchFolder();
  writeSeries(folder / "images" / "deep", along({0, 0, 1}, 3));
  fs::copy_file(folder / "images" / "deep" / "s2-0", folder / "DICOMDIR");
  EXPECT_EQ(io::openVolume(folder / "DICOMDIR").volume->grid.dims.z, 3);
}

TEST(Dicom, ProgressGrowsAndCancels) {
  const fs::path folder = scratchFolder();
  writeSeries(folder, along({0, 0, 1}, 20));
  std::vector<double> fractions;
  io::OpenOptions options;
  options.progress = [&](double fraction, std::string_view) {
    fractions.push_back(fraction);
    return true;
  };
  io::openVolume(folder, options);
  EXPECT_EQ(fractions.size(), 40u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_LE(fractions.back(), 1.0);
  for (const std::size_t stop : {std::size_t{1}, std::size_t{25}}) {
    std::size_t calls = 0;
    options.progress = [&](double, std::string_view) { return ++calls < stop; };
    EXPECT_THROW(io::openVolume(folder, options), io::Cancelled);
    EXPECT_EQ(calls, stop);
  }
}

}  // namespace fenestra::tests::dicomTest
