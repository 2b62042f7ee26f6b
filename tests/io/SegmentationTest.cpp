// DICOM segmentations of known content, in every kind and order.

#include <algorithm>
#include <chrono>
#include <random>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::segmentationTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

const Grid fiveByThree = labelGrid({5, 3, 3});

/// Fifteen pixels of 5 x 3, of which those in `set` are `value`.
std::vector<int> pixels(std::initializer_list<int> set, int value = 1) {
  std::vector<int> result(15, 0);
  for (const int i : set) result[static_cast<std::size_t>(i)] = value;
  return result;
}

/// Two segments on three planes, frames out of order; the second segment has no frame on the middle plane.
SegSpec twoSegments() {
  SegSpec spec;
  spec.segments = {{1, "Leber", {}}, {7, "Gefäß", {}}};
  spec.frames = {{7, glm::dvec3(0, 0, 2), pixels({14})},
                 {1, glm::dvec3(0, 0, 1), pixels({0, 7})},
                 {1, glm::dvec3(0, 0, 2), pixels({0, 1, 2})},
                 {7, glm::dvec3(0, 0, 0), pixels({6, 8})},
                 {1, glm::dvec3(0, 0, 0), pixels({3})}};
  return spec;
}

std::vector<int> twoSegmentsTruth() {
  std::vector<int> truth(45, 0);
  for (const int i : {3, 15, 22, 30, 31, 32}) truth[static_cast<std::size_t>(i)] = 1;
  for (const int i : {6, 8, 44}) truth[static_cast<std::size_t>(i)] = 7;
  return truth;
}

std::string errorOfLabels(const fs::path& path, const Grid& target = fiveByThree) {
  return errorOf([&] { io::openLabels(path, target); });
}

}  // namespace

TEST(Segmentation, FramesThatBeginOnBytesOfTheirOwnAreReadAndSaid) {
  const fs::path path = scratchFolder() / "seg.dcm";
  // 3 x 3 pixels: 9 frames take 11 bytes packed and 18 padded.
  SegSpec spec;
  spec.columns = spec.rows = 3;
  std::vector<int> truth;
  for (int z = 0; z < 9; ++z) {
    std::vector<int> frame(9, 0);
    frame[static_cast<std::size_t>(z)] = frame[8] = 1;
    truth.insert(truth.end(), frame.begin(), frame.end());
    spec.frames.push_back({1, glm::dvec3(0, 0, z), frame});
  }
  for (const bool pads : {false, true}) {
    spec.padsFrames = pads;
    writeSeg(path, spec);
    const io::OpenedLabels opened = io::openLabels(path, labelGrid({3, 3, 9}));
    EXPECT_EQ(valuesOf(*opened.labels), truth) << pads;
    EXPECT_EQ(opened.warnings.size(), pads ? 1u : 0u) << kindsOf(opened.warnings);
    if (pads) {
      EXPECT_NE(opened.warnings.front().text.find("frames of 9 bits begins on a byte of its own"), std::string::npos);
    }
  }
}

TEST(Segmentation, WhereALengthFitsPackedAndPaddedFramesTheBitsBehindTheLastTell) {
  const fs::path path = scratchFolder() / "seg.dcm";
  // Five frames of 15 bits take ten bytes either way; the last frame's last pixel is bit 78 when padded.
  SegSpec spec = twoSegments();
  spec.frames.back().pixels = pixels({3, 14});
  std::vector<int> truth = twoSegmentsTruth();
  truth[14] = 1;
  for (const bool pads : {false, true}) {
    spec.padsFrames = pads;
    writeSeg(path, spec);
    EXPECT_EQ(valuesOf(*io::openLabels(path, fiveByThree).labels), truth) << pads;
  }
}

TEST(Segmentation, BitsOfOddFramesInAnyOrderInEverySyntax) {
  const fs::path path = scratchFolder() / "seg.dcm";
  for (const char* syntax : {"explicit", "implicit", "big", "deflated"}) {
    SCOPED_TRACE(syntax);
    SegSpec spec = twoSegments();
    spec.transferSyntax = syntax;
    writeSeg(path, spec);
    const io::OpenedLabels opened = io::openLabels(path, fiveByThree);
    EXPECT_EQ(valuesOf(*opened.labels), twoSegmentsTruth());
    EXPECT_EQ(opened.labels->find(1)->name, "Leber");
    EXPECT_EQ(opened.labels->find(7)->name, "Gefäß");
    EXPECT_TRUE(opened.warnings.empty()) << opened.warnings.front().text;
  }
}

TEST(Segmentation, ColoursAreRecommendedDisplayValues) {
  const fs::path path = scratchFolder() / "seg.dcm";
  SegSpec spec = twoSegments();
  // The sRGB colour 221, 130, 101 against D65, as dcmqi's files hold it.
  const auto word = [](double value, double low, double high) {
    return static_cast<int>(std::lround((value - low) / (high - low) * 65535.0));
  };
  spec.segments[0].cieLab = {word(63.574, 0, 100), word(32.179, -128, 127), word(30.730, -128, 127)};
  writeSeg(path, spec);
  const io::OpenedLabels opened = io::openLabels(path, fiveByThree);
  const glm::dvec3 expected = glm::dvec3(221, 130, 101) / 255.0;
  // Lab values of three decimals and 16-bit words leave less than a quarter of a step of 8 bits.
  EXPECT_LT(glm::distance(opened.labels->find(1)->colour, expected), 0.001);
  EXPECT_EQ(opened.labels->find(7)->colour, defaultLabelColour(7));
}

TEST(Segmentation, TheSmallerOfOverlappingSegmentsStaysWhateverTheOrder) {
  const fs::path path = scratchFolder() / "seg.dcm";
  for (const bool swapped : {false, true}) {
    SegSpec spec;
    spec.segments = {{1, "organ", {}}, {2, "lesion", {}}};
    spec.frames = {{1, glm::dvec3(0.0), pixels({5, 6, 7, 8})}, {2, glm::dvec3(0.0), pixels({7, 8, 9})}};
    if (swapped) {
      std::swap(spec.segments[0], spec.segments[1]);
      std::swap(spec.frames[0], spec.frames[1]);
    }
    writeSeg(path, spec);
    const io::OpenedLabels opened = io::openLabels(path, labelGrid({5, 3, 1}));
    EXPECT_EQ(valuesOf(*opened.labels), (std::vector<int>{0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 0, 0, 0, 0, 0}));
    const std::string text = warningOf(opened.warnings, Warning::Kind::Other).text;
    EXPECT_NE(text.find("overlap at 2 voxels"), std::string::npos) << text;
    EXPECT_NE(text.find("lesion over organ at 2"), std::string::npos) << text;
  }
}

TEST(Segmentation, FractionalVoxelsBelongFromOneHalfOn) {
  const fs::path path = scratchFolder() / "seg.dcm";
  for (const char* syntax : {"explicit", "rle"}) {
    SegSpec spec;
    spec.type = "FRACTIONAL";
    spec.transferSyntax = syntax;
    spec.bits = 8;
    spec.greatest = 200;
    spec.frames = {{1, glm::dvec3(0.0), {0, 1, 99, 100, 101, 200, 0, 0, 0, 0, 0, 0, 0, 0, 150}}};
    writeSeg(path, spec);
    const io::OpenedLabels opened = io::openLabels(path, labelGrid({5, 3, 1}));
    EXPECT_EQ(valuesOf(*opened.labels), (std::vector<int>{0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1})) << syntax;
    EXPECT_NE(warningOf(opened.warnings, Warning::Kind::Other).text.find("one half"), std::string::npos);
  }
}

TEST(Segmentation, LabelMapsHoldSegmentNumbers) {
  const fs::path path = scratchFolder() / "seg.dcm";
  for (const int bits : {8, 16})
    for (const char* syntax : {"explicit", "rle"}) {
      SegSpec spec;
      spec.type = "LABELMAP";
      spec.sopClass = "1.2.840.10008.5.1.4.1.1.66.7";
      spec.transferSyntax = syntax;
      spec.bits = bits;
      const int high = bits == 8 ? 255 : 40000;
      spec.segments = {{1, "one", {}}, {high, "high", {}}, {0, "background", {}}};
      spec.frames = {{0, glm::dvec3(0, 0, 1), pixels({2, 3}, high)}, {0, glm::dvec3(0, 0, 0), pixels({0, 14})}};
      writeSeg(path, spec);
      const io::OpenedLabels opened = io::openLabels(path, labelGrid({5, 3, 2}));
      std::vector<int> truth(30, 0);
      truth[0] = truth[14] = 1;
      truth[17] = truth[18] = high;
      EXPECT_EQ(valuesOf(*opened.labels), truth) << bits << " " << syntax;
      EXPECT_EQ(opened.labels->find(static_cast<std::uint16_t>(high))->name, "high");
      EXPECT_EQ(opened.labels->labels.size(), 2u);
    }
}

TEST(Segmentation, ComesToFlippedObliqueAndShearedGrids) {
  const fs::path path = scratchFolder() / "seg.dcm";
  SegSpec spec = twoSegments();
  // Rotated about z by the angle with cosine 0.8, and stepping sideways from plane to plane as a tilted gantry does.
  spec.row = {0.8, 0.6, 0};
  spec.column = {-0.6, 0.8, 0};
  const glm::dvec3 step(0.3, -0.1, 2.0);
  for (SegFrameSpec& frame : spec.frames) frame.position = glm::dvec3(10, 20, 30) + frame.position->z * step;
  spec.spacingBetweenSlices = "2";
  spec.pixelSpacing = "0.5\\0.7";  // between rows, between columns
  writeSeg(path, spec);
  Grid grid = labelGrid({5, 3, 3}, {10, 20, 30}, {0.7, 0.5, glm::length(step)});
  grid.direction = {spec.row, spec.column, glm::normalize(step)};
  const io::OpenedLabels same = io::openLabels(path, grid);
  EXPECT_EQ(valuesOf(*same.labels), twoSegmentsTruth());
  EXPECT_TRUE(same.warnings.empty()) << same.warnings.front().text;

  // This grid has the same lattice, with x reversed and z first.
  Grid flipped;
  flipped.dims = {3, 5, 3};
  flipped.spacing = {grid.spacing.z, 0.7, 0.5};
  flipped.direction = {grid.direction[2], -spec.row, spec.column};
  flipped.origin = grid.origin + 4.0 * 0.7 * spec.row;
  const io::OpenedLabels turned = io::openLabels(path, flipped);
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x)
        EXPECT_EQ(turned.labels->value({z, 4 - x, y}),
                  twoSegmentsTruth()[static_cast<std::size_t>(x + 5 * y + 15 * z)]);
  EXPECT_TRUE(turned.warnings.empty()) << turned.warnings.front().text;
}

TEST(Segmentation, OtherGridsTakeTheNearestPixelWithinTheSlab) {
  const fs::path path = scratchFolder() / "seg.dcm";
  SegSpec spec;
  spec.frames = {{1, glm::dvec3(0, 0, 10), pixels({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14})},
                 {1, glm::dvec3(0, 0, 16), pixels({7})}};
  spec.spacingBetweenSlices = "2";  // planes at 12 and 14 are empty and left out
  writeSeg(path, spec);
  // Half a millimetre apart along z, from 8 on.
  const io::OpenedLabels opened = io::openLabels(path, labelGrid({1, 1, 24}, {2, 1, 8}, {1, 1, 0.5}));
  std::vector<int> truth(24, 0);
  for (std::size_t k = 0; k < 24; ++k) {
    const double z = 8 + 0.5 * static_cast<double>(k);
    truth[k] = std::abs(z - 10) <= 1.0 || std::abs(z - 16) <= 1.0;
  }
  EXPECT_EQ(valuesOf(*opened.labels), truth);
  EXPECT_NE(warningOf(opened.warnings, Warning::Kind::Other).text.find("resampled"), std::string::npos);
  const io::OpenedLabels away = io::openLabels(path, labelGrid({4, 4, 4}, {100, 0, 0}));
  EXPECT_NE(warningOf(away.warnings, Warning::Kind::Other).text.find("outside the volume"), std::string::npos);
}

TEST(Segmentation, ThoseOfASeriesAreListedWithIt) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 3; ++i) {
    DicomSpec slice;
    slice.instance = "1.2.3.4." + std::to_string(i);
    slice.position = glm::dvec3(0, 0, i);
    writeDicom(folder / ("slice" + std::to_string(i)), slice);
  }
  SegSpec spec = twoSegments();
  writeSeg(folder / "own.dcm", spec);
  spec.series = "";  // the frame of reference alone
  writeSeg(folder / "same-frame.dcm", spec);
  spec.series = "9.9.9";
  writeSeg(folder / "other.dcm", spec);
  RtSpec plan;
  plan.rois = {{1, "Herz", "255\\0\\0", {{rectangle(0, 0, 2, 2, 0), "CLOSED_PLANAR", {}, {}}}}};
  writeRtStruct(folder / "plan.dcm", plan);

  const io::OpenedVolume opened = io::openVolume(folder);
  ASSERT_EQ(opened.segmentations.size(), 3u);
  EXPECT_EQ(opened.segmentations[0].file, folder / "own.dcm");
  EXPECT_EQ(opened.segmentations[0].kind, "SEG");
  EXPECT_EQ(opened.segmentations[0].description, "made up");
  EXPECT_EQ(opened.segmentations[0].structures, (std::vector<std::string>{"Leber", "Gefäß"}));
  EXPECT_EQ(opened.segmentations[1].file, folder / "plan.dcm");
  EXPECT_EQ(opened.segmentations[1].kind, "RTSTRUCT");
  EXPECT_EQ(opened.segmentations[1].description, "plan");
  EXPECT_EQ(opened.segmentations[1].structures, (std::vector<std::string>{"Herz"}));
  EXPECT_EQ(opened.segmentations[2].file, folder / "same-frame.dcm");
  ASSERT_EQ(opened.warnings.size(), 1u);
  EXPECT_NE(opened.warnings[0].text.find("another series"), std::string::npos);
  EXPECT_EQ(opened.warnings[0].files, (std::vector<fs::path>{folder / "other.dcm"}));

  const std::string asVolume = errorOf([&] { io::openVolume(folder / "own.dcm"); });
  EXPECT_NE(asVolume.find("own.dcm: is a DICOM segmentation"), std::string::npos) << asVolume;
  EXPECT_NE(asVolume.find("as labels"), std::string::npos) << asVolume;
  EXPECT_NE(errorOfLabels(folder / "slice0").find("neither a segmentation"), std::string::npos);
}

TEST(Segmentation, DamageIsAnErrorInBoundedTime) {
  const fs::path folder = scratchFolder();
  writeSeg(folder / "seg.dcm", twoSegments());
  RtSpec plan;
  plan.rois = {{1, "Herz", "255\\0\\0", {{rectangle(0, 0, 2, 2, 0), "CLOSED_PLANAR", {}, {}}}},
               {2, "Lunge", "", {{rectangle(1, 1, 4, 3, 1), "CLOSED_PLANAR", {}, {}}}}};
  writeRtStruct(folder / "plan.dcm", plan);
  const auto start = std::chrono::steady_clock::now();
  std::mt19937 random(20261122);
  testing::internal::CaptureStderr();
  for (const char* name : {"seg.dcm", "plan.dcm"}) {
    const std::string whole = readFile(folder / name);
    for (std::size_t size = 0; size < whole.size(); size += 37) {
      writeFile(folder / "cut.dcm", whole.substr(0, size));
      EXPECT_THROW(io::openLabels(folder / "cut.dcm", fiveByThree), io::Error) << name << " cut to " << size;
    }
    for (int round = 0; round < 400; ++round) {
      std::string bytes = whole;
      for (int flips = 1 + round % 4; flips > 0; --flips) bytes[random() % bytes.size()] = static_cast<char>(random());
      writeFile(folder / "flipped.dcm", bytes);
      try {
        io::openLabels(folder / "flipped.dcm", fiveByThree);
      } catch (const io::Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  // A thousand files of a kilobyte; a minute is a hundred times what they take.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

}  // namespace fenestra::tests::segmentationTest
