// Where the slices of each kind of object lie: every row of the table of FramePlaces.h, and of Mosaic.h.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/DicomMakes.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::dicomPlacesTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

/// A file or folder, the grid that it must have, the first value of each slice, and a warning that it must give.
struct PlaceRow {
  std::string name;
  Make make;
  glm::ivec3 dims{4, 3, 3};
  glm::dvec3 origin{0.0}, step{0, 0, 1};  ///< of the first slice, and from slice to slice
  glm::dvec2 spacing{0.5};
  std::vector<double> values{0, 12, 24};
  std::string says = {};  ///< empty: no warning
};
std::ostream& operator<<(std::ostream& stream, const PlaceRow& row) { return stream << row.name; }

std::string doubles(const std::vector<double>& values) { return bytesOf(values); }
std::string shorts(const std::vector<int>& values) {
  std::string bytes;
  for (const int value : values) bytes += shortValue(value);
  return bytes;
}

const std::string axial = "1\\0\\0\\0\\1\\0";
const Edit spacingOfHalf = set(pixelSpacing, "DS", "0.5\\0.5"), place = set(position, "DS", "-10\\-20\\30"),
           plane = set(orientation, "DS", axial);

/// One file of frames without functional groups.
Make frames(const std::string& sopClass, const std::string& modalityText, std::vector<Edit> edits, int count = 3) {
  DicomSpec spec;
  spec.sopClass = sopClass;
  spec.modality = modalityText;
  spec.numberOfFrames = count;
  spec.position.reset();
  edits.push_back(spacingOfHalf);
  return file(edits, spec);
}

const std::string ctClass = "1.2.840.10008.5.1.4.1.1.2", nmClass = "1.2.840.10008.5.1.4.1.1.20",
                  secondaryClass = "1.2.840.10008.5.1.4.1.1.7.2", usClass = "1.2.840.10008.5.1.4.1.1.6.2",
                  doseClass = "1.2.840.10008.5.1.4.1.1.481.2";
constexpr std::uint32_t between = 0x00180088, increment = 0x00280009, sliceVector = 0x00540080, detectors = 0x00540022;
const Edit sliceFrames = set(increment, "AT", tagValue(sliceVector));

Edit inDetector() {
  return set(detectors, "SQ", item(element(position, "DS", "-10\\-20\\30") + element(orientation, "DS", axial + " ")));
}
Make nuclear(const std::string& step, const std::vector<int>& order, const std::vector<Edit>& more = {}) {
  std::vector<Edit> edits{inDetector(), set(between, "DS", step), sliceFrames, set(sliceVector, "US", shorts(order))};
  edits.insert(edits.end(), more.begin(), more.end());
  return frames(nmClass, "NM", edits, static_cast<int>(order.size()));
}

/// Frames with a place each in the frame of an ultrasound volume.
Make ultrasound() {
  std::string own;
  for (int i = 0; i < 3; ++i)
    own += item(sequence(0x0020930e, element(0x00209301, "FD", doubles({-10, -20, 30 + 2.0 * i}))));
  const std::string shared = item(sequence(0x0020930f, element(0x00209302, "FD", doubles({1, 0, 0, 0, 1, 0}))) +
                                  sequence(0x00289110, element(pixelSpacing, "DS", "0.5\\0.5 ")));
  return frames(usClass, "US", {set(0x52009229, "SQ", shared), set(0x52009230, "SQ", own)});
}

/// Single slices, each with edits of its own.
Make slices(const std::function<std::vector<Edit>(int slice)>& own, bool placed = true) {
  return series(
      3,
      [=](int slice, DicomSpec& spec) {
        const DicomSpec small;
        spec.rows = small.rows;
        spec.columns = small.columns;
        spec.words.assign(12, static_cast<std::uint32_t>(12 * slice));
        if (!placed) spec.position.reset();
      },
      {}, own);
}

/// A picture of 2 x 2 tiles of 4 x 3 pixels, the last one empty; tile n holds 12 n.
Make grid(bool whole) {
  DicomSpec spec;
  spec.modality = "MR";
  spec.columns = 8;
  spec.rows = 6;
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) spec.words.push_back(static_cast<std::uint32_t>(12 * (y / 3 * 2 + x / 4)));
  std::string tiles;
  for (int i = 0; i < (whole ? 3 : 2); ++i)
    tiles += item(element(position, "DS", "-10\\-20\\" + std::to_string(30 + 2 * i)));
  return file({place, plane, spacingOfHalf, set(0x00650010, "LO", "Image Private Header"), set(0x00651050, "DS", "3"),
               set(0x00651051, "SQ", tiles)},
              spec);
}

std::vector<PlaceRow> placeRows() {
  const glm::dvec3 at(-10, -20, 30);
  const std::string follows = "the file gives the place of its first frame alone";
  const std::string nowhere = "the file does not say where its slices lie";
  const auto positions = [](const char* vr) {
    return [=](int slice) {
      return std::vector{set(position, vr, "-10\\-20\\" + std::to_string(30 + 2 * slice)), set(orientation, vr, axial),
                         set(pixelSpacing, vr, "0.5\\0.5")};
    };
  };
  const auto located = [](std::vector<double> heights, bool oriented) {
    return [=](int slice) {
      std::vector<Edit> edits{
          set(0x00201041, "DS", std::to_string(heights[static_cast<std::size_t>(slice)]).substr(0, 6)),
          set(sliceThickness, "DS", "1.25"), spacingOfHalf};
      if (oriented) edits.push_back(set(orientation, "DS", "0\\1\\0\\0\\0\\-1"));
      return edits;
    };
  };
  DicomSpec enhanced;
  enhanced.frames = {{{-10, -20, 30}}, {{-10, -20, 32}}, {{-10, -20, 34}}};
  enhanced.pixelSpacing = "0.5\\0.5";
  return {
      {"Single", slices(positions("DS")), {4, 3, 3}, at, {0, 0, 2}},
      {"SingleOfUnlimitedText", slices(positions("UT")), {4, 3, 3}, at, {0, 0, 2}},
      {"Enhanced", file({}, enhanced), {4, 3, 3}, at, {0, 0, 2}},
      {"UltrasoundVolume",
       ultrasound(),
       {4, 3, 3},
       at,
       {0, 0, 2},
       {0.5, 0.5},
       {0, 12, 24},
       "placed in the frame of the ultrasound volume"},
      {"Nuclear", nuclear("4.4", {1, 2, 3}), {4, 3, 3}, at, {0, 0, 4.4}},
      {"NuclearBackwards",
       nuclear("-4.4", {1, 2, 3}),
       {4, 3, 3},
       at - glm::dvec3(0, 0, 8.8),
       {0, 0, 4.4},
       {0.5, 0.5},
       {24, 12, 0}},
      {"NuclearInAnotherOrder", nuclear("4.4", {3, 1, 2}), {4, 3, 3}, at, {0, 0, 4.4}, {0.5, 0.5}, {12, 24, 0}},
      {"NuclearGated",
       nuclear("4.4", {1, 2, 3, 1, 2, 3}, {set(0x00540070, "US", shorts({1, 1, 1, 2, 2, 2}))}),
       {4, 3, 3},
       at,
       {0, 0, 4.4},
       {0.5, 0.5},
       {0, 12, 24},
       "told apart by time slot"},
      {"NuclearOfTwoEnergies",
       nuclear("4.4", {1, 2, 3, 1, 2, 3}, {set(0x00540010, "US", shorts({1, 1, 1, 2, 2, 2}))}),
       {4, 3, 3},
       at,
       {0, 0, 4.4},
       {0.5, 0.5},
       {0, 12, 24},
       "energy window 2; this volume: energy window 1"},
      {"NuclearProjections",
       frames(nmClass, "NM", {inDetector(), set(between, "DS", "4.4"), set(increment, "AT", tagValue(0x00540090))}),
       {4, 3, 3},
       {0, 0, 0},
       {0, 0, 4.4},
       {0.5, 0.5},
       {0, 12, 24},
       nowhere},
      {"ConeBeam",
       frames(ctClass, "CT", {place, plane, set(between, "DS", "0.3"), set(sliceThickness, "DS", "1.0")}),
       {4, 3, 3},
       at,
       {0, 0, 0.3},
       {0.5, 0.5},
       {0, 12, 24},
       follows},
      {"ConeBeamWithoutPosition",
       frames(ctClass, "CT", {set(between, "DS", "0.3"), set(sliceThickness, "DS", "1.0")}),
       {4, 3, 3},
       {0, 0, 0},
       {0, 0, 0.3},
       {0.5, 0.5},
       {0, 12, 24},
       "a guess (0.3 mm, their Spacing Between Slices)"},
      {"ThicknessAlone",
       frames(ctClass, "CT", {set(sliceThickness, "DS", "1.25")}),
       {4, 3, 3},
       {0, 0, 0},
       {0, 0, 1.25},
       {0.5, 0.5},
       {0, 12, 24},
       "a guess (1.25 mm, their Slice Thickness)"},
      {"FramesInTime",
       frames("1.2.840.10008.5.1.4.1.1.12.1", "XA",
              {place, plane, set(between, "DS", "0.3"), set(0x00181063, "DS", "33"),
               set(increment, "AT", tagValue(0x00181063))}),
       {4, 3, 3},
       {0, 0, 0},
       {0, 0, 0.3},
       {0.5, 0.5},
       {0, 12, 24},
       nowhere},
      {"SliceLocationVector",
       frames(secondaryClass, "OT",
              {place, plane, set(increment, "AT", tagValue(0x00182005)),
               set(0x00182005, "FL", bytesOf(std::vector<float>{100.0F, 102.5F, 105.0F}))}),
       {4, 3, 3},
       at,
       {0, 0, 2.5}},
      {"Dose",
       frames(doseClass, "RTDOSE",
              {place, plane, set(0x3004000c, "DS", "0\\2.5\\5"), set(doseScaling, "DS", "1"), set(between, "DS", "9")}),
       {4, 3, 3},
       at,
       {0, 0, 2.5}},
      {"DoseOfHeights",
       frames(doseClass, "RTDOSE", {place, plane, set(0x3004000c, "DS", "30\\32.5\\35"), set(doseScaling, "DS", "1")}),
       {4, 3, 3},
       at,
       {0, 0, 2.5}},
      {"DoseDownwards",
       frames(doseClass, "RTDOSE", {place, plane, set(0x3004000c, "DS", "0\\-2.5\\-5"), set(doseScaling, "DS", "1")}),
       {4, 3, 3},
       at - glm::dvec3(0, 0, 5),
       {0, 0, 2.5},
       {0.5, 0.5},
       {24, 12, 0}},
      {"SliceLocationVectorDownwards",
       frames(secondaryClass, "OT",
              {place, plane, set(increment, "AT", tagValue(0x00182005)),
               set(0x00182005, "FL", bytesOf(std::vector<float>{100.0F, 97.5F, 95.0F}))}),
       {4, 3, 3},
       at - glm::dvec3(0, 0, 5),
       {0, 0, 2.5},
       {0.5, 0.5},
       {24, 12, 0}},
      {"SliceLocation",
       slices(located({5.0, 2.5, 7.5}, false), false),
       {4, 3, 3},
       {0, 0, 0},
       {0, 0, 2.5},
       {0.5, 0.5},
       {12, 0, 24},
       "their Slice Location gives their order and a distance of 2.5 mm"},
      {"SliceLocationWithOrientation",
       slices(located({5.0, 2.5, 7.5}, true), false),
       {4, 3, 3},
       {0, 0, 0},
       {-2.5, 0, 0},
       {0.5, 0.5},
       {12, 0, 24},
       "their Slice Location gives their order"},
      {"OneSliceLocationForAll",
       slices(located({5.0, 5.0, 5.0}, false), false),
       {4, 3, 3},
       {0, 0, 0},
       {0, 0, 1.25},
       {0.5, 0.5},
       {0, 12, 24},
       "shown in their stored order"},
      {"UnitedImagingGrid", grid(true), {4, 3, 3}, at, {0, 0, 2}},
      {"UnitedImagingGridOfUnknownLayout",
       grid(false),
       {8, 6, 1},
       at,
       {0, 0, 1},
       {0.5, 0.5},
       {0},
       "side by side in one picture"},
      {"UltrasoundRegion",
       file({drop(pixelSpacing),
             set(0x00186011, "SQ",
                 item(element(0x00186024, "US", shortValue(3)) + element(0x00186026, "US", shortValue(3)) +
                      element(0x0018602c, "FD", doubles({0.02})) + element(0x0018602e, "FD", doubles({0.03}))))},
            DicomSpec{}),
       {4, 3, 1},
       {0, 0, 0},
       {0, 0, 1},
       {0.2, 0.3},
       {0}},
  };
}

}  // namespace

class DicomPlaces : public ::testing::TestWithParam<PlaceRow> {};

TEST_P(DicomPlaces, AreWhereTheStandardHasThem) {
  const PlaceRow& row = GetParam();
  const io::OpenedVolume opened = io::openVolume(row.make(scratchFolder()));
  const Grid& grid = opened.volume->grid;
  ASSERT_EQ(grid.dims, row.dims);
  // Sums of decimal strings.
  constexpr double rounding = 1e-9;
  EXPECT_LE(glm::distance(grid.origin, row.origin), rounding);
  EXPECT_LE(glm::distance(grid.direction[2] * grid.spacing.z, row.step), rounding);
  EXPECT_LE(glm::distance(glm::dvec2(grid.spacing), row.spacing), rounding);
  std::vector<double> values;
  for (int z = 0; z < grid.dims.z; ++z) values.push_back(opened.volume->value({0, 0, z}));
  EXPECT_EQ(values, row.values);
  std::string all;
  for (const Warning& warning : opened.warnings) all += warning.text + "\n";
  EXPECT_EQ(all.empty(), row.says.empty()) << all;
  EXPECT_NE(all.find(row.says), std::string::npos) << all;
}

INSTANTIATE_TEST_SUITE_P(All, DicomPlaces, ::testing::ValuesIn(placeRows()),
                         [](const auto& test) { return test.param.name; });

}  // namespace fenestra::tests::dicomPlacesTest
