// Which attributes part the images of a series: every row of the table of ImageParts.h.

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/DicomMakes.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::dicomPartsTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

/// An attribute with two values, and what the volume of the first one is called; no name: it parts where places repeat.
struct PartRow {
  std::string name, modality;
  std::vector<Edit> first, second;
  std::string part = {};
};
std::ostream& operator<<(std::ostream& stream, const PartRow& row) { return stream << row.name; }

PartRow texts(const char* name, const char* modality, std::uint32_t tag, const char* vr, const char* first,
              const char* second, const char* part = "") {
  return {name, modality, {set(tag, vr, first)}, {set(tag, vr, second)}, part};
}

/// A private attribute behind its owner.
PartRow own(const char* name, std::uint32_t group, const char* creator, std::uint32_t element, const char* vr,
            const std::string& first, const std::string& second, const char* part) {
  const auto edits = [=](const std::string& value) {
    return std::vector{set(group << 16 | 0x10, "LO", creator), set(group << 16 | 0x1000 | element, vr, value)};
  };
  return {name, "MR", edits(first), edits(second), part};
}

std::vector<PartRow> rowsThatAlwaysPart() {
  const char* siemens = "SIEMENS MR HEADER";
  return {
      texts("EchoTime", "MR", 0x00180081, "DS", "2.46", "4.92", "echo time 2.46 ms"),
      texts("EchoNumber", "MR", 0x00180086, "IS", "1", "2", "echo number 1"),
      texts("FlipAngle", "MR", 0x00181314, "DS", "5", "30", "flip angle 5 degrees"),
      texts("Phase", "MR", 0x00080008, "CS", "ORIGINAL\\PRIMARY\\M\\ND", "ORIGINAL\\PRIMARY\\P\\ND",
            "image component magnitude"),
      texts("PhilipsPhase", "MR", 0x00080008, "CS", "ORIGINAL\\PRIMARY\\M_FFE\\M\\FFE",
            "ORIGINAL\\PRIMARY\\PHASE MAP\\P\\FFE", "image component magnitude"),
      texts("RealPart", "MR", 0x00080008, "CS", "ORIGINAL\\PRIMARY\\R", "ORIGINAL\\PRIMARY\\I", "image component real"),
      texts("Dixon", "MR", 0x00080008, "CS", "DERIVED\\PRIMARY\\DIXON\\WATER", "DERIVED\\PRIMARY\\DIXON\\FAT",
            "image component water"),
      own("GeComponent", 0x0043, "GEMS_PARM_01", 0x2f, "SS", shortValue(2), shortValue(3), "image component real"),
      texts("ComplexComponent", "MR", 0x00089208, "CS", "MAGNITUDE", "PHASE", "image component MAGNITUDE"),
      {"BValue",
       "MR",
       {set(0x00189087, "FD", bytesOf(0.0))},
       {set(0x00189087, "FD", bytesOf(1000.0))},
       "b-value 0 s/mm^2"},
      own("BValueOfSiemens", 0x0019, siemens, 0x0c, "IS", "50", "800", "b-value 50 s/mm^2"),
      own("BValueOfSiemensUnknown", 0x0019, siemens, 0x0c, "UN", "50", "800 ", "b-value 50 s/mm^2"),
      own("BValueOfGe", 0x0043, "GEMS_PARM_01", 0x39, "IS", "1000000800\\8\\0\\0", "0\\8\\0\\0", "b-value 800 s/mm^2"),
      own("BValueOfPhilips", 0x2001, "Philips Imaging DD 001", 0x03, "FL", bytesOf(600.0F), bytesOf(0.0F),
          "b-value 600 s/mm^2"),
      own("BValueOfPhilipsUnknown", 0x2001, "Philips Imaging DD 001", 0x03, "UN", bytesOf(600.0F), bytesOf(0.0F),
          "b-value 600 s/mm^2"),
      own("BValueOfUnited", 0x0065, "Image Private Header", 0x09, "FD", bytesOf(600.0), bytesOf(0.0),
          "b-value 600 s/mm^2"),
      texts("TubeVoltage", "CT", 0x00180060, "DS", "80", "140", "tube voltage 80 kV"),
      {"EnergyWeighting",
       "CT",
       {set(0x00189353, "FL", bytesOf(0.5F))},
       {set(0x00189353, "FL", bytesOf(1.0F))},
       "energy weighting 0.5"},
      texts("Kernel", "CT", 0x00181210, "SH", "B30f", "B70f", "reconstruction kernel B30f"),
      texts("ContrastPhase", "CT", 0x00189344, "CS", "PRE_CONTRAST", "POST_CONTRAST", "contrast phase PRE_CONTRAST"),
  };
}

std::vector<PartRow> rowsThatPartRepeats() {
  return {
      texts("SeriesNumber", "MR", 0x00200011, "IS", "3", "4"),
      texts("SliceThickness", "CT", 0x00180050, "DS", "1", "3"),
      texts("TemporalPosition", "MR", 0x00200100, "IS", "1", "2"),
      {"CardiacPhase", "MR", {set(0x00209241, "FL", bytesOf(10.0F))}, {set(0x00209241, "FL", bytesOf(60.0F))}},
      texts("TriggerTime", "MR", 0x00181060, "DS", "10", "500"),
      texts("AcquisitionNumber", "CT", 0x00200012, "IS", "1", "2"),
      texts("FrameReferenceTime", "PT", 0x00541300, "DS", "100", "90000"),
      texts("InversionTime", "MR", 0x00180082, "DS", "100", "900"),
      texts("RepetitionTime", "MR", 0x00180080, "DS", "1000", "3000"),
      texts("ImageType", "CT", 0x00080008, "CS", "ORIGINAL\\PRIMARY\\AXIAL", "DERIVED\\SECONDARY\\VMI"),
      texts("SequenceName", "MR", 0x00180024, "SH", "*ep_b0", "*ep_b1000#1"),
      texts("ContrastAgent", "CT", 0x00180010, "LO", "", "Imeron"),
      texts("AcquisitionTime", "CT", 0x00080032, "TM", "101112.5", "101500.25"),
      texts("ContentTime", "CT", 0x00080033, "TM", "101112.5", "101500.25"),
  };
}

/// Writes a slice of value 10 or 20 (of the attribute's first or second value) and its number.
void write(const fs::path& folder, const PartRow& row, bool second, int number, double height) {
  DicomSpec spec;
  spec.modality = row.modality;
  spec.instance = std::string(second ? "1.2.2." : "1.2.1.") + std::to_string(number + 1);
  spec.instanceNumber = number + 1;
  spec.position = glm::dvec3(0, 0, height);
  spec.words.assign(12, static_cast<std::uint32_t>((second ? 20 : 10) + number));
  writeEdited(folder / spec.instance, spec, second ? row.second : row.first);
}

std::vector<double> slicesOf(const Volume& volume) {
  std::vector<double> values;
  for (int z = 0; z < volume.grid.dims.z; ++z) values.push_back(volume.value({0, 0, z}));
  return values;
}
const std::vector<double> firstValues{10, 11, 12, 13}, secondValues{20, 21, 22, 23};

bool saysAny(const std::vector<Warning>& warnings, const std::string& text) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const Warning& warning) { return warning.text.find(text) != std::string::npos; });
}

/// Both volumes can be opened, and hold the slices of one value each.
void expectBoth(const fs::path& folder) {
  const std::vector<io::SeriesInfo> series = io::listSeries(folder);
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(slicesOf(*io::openVolume(folder, {.series = series[0].id}).volume), firstValues);
  EXPECT_EQ(slicesOf(*io::openVolume(folder, {.series = series[1].id}).volume), secondValues);
}

}  // namespace

class DicomParts : public ::testing::TestWithParam<PartRow> {};

TEST_P(DicomParts, OfTheSamePlacesAndNumbersAreTwoVolumes) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 4; ++i)
    for (const bool second : {false, true}) write(folder, GetParam(), second, i, 2.0 * i);
  expectBoth(folder);
  EXPECT_EQ(io::listSeries(folder)[0].part, GetParam().part);
  const auto opened = io::openVolume(folder);
  EXPECT_TRUE(saysAny(opened.warnings, "4 slices of the series put into volumes of their own"));
}

TEST_P(DicomParts, ThatInterleaveAreTwoVolumes) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 4; ++i)
    for (const bool second : {false, true}) write(folder, GetParam(), second, i, 2.0 * i + (second ? 0.7 : 0.0));
  expectBoth(folder);
  EXPECT_FALSE(saysAny(io::openVolume(folder).warnings, "apart"));
}

TEST_P(DicomParts, AMissingSliceStaysMissing) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 6; ++i) {
    if (i != 2) write(folder, GetParam(), false, i, 2.0 * i);
    if (i != 3) write(folder, GetParam(), true, i, 2.0 * i);
  }
  const std::vector<io::SeriesInfo> series = io::listSeries(folder);
  ASSERT_EQ(series.size(), 2u);
  for (const io::SeriesInfo& each : series) {
    const io::OpenedVolume opened = io::openVolume(folder, {.series = each.id, .regularise = io::Regularise::Off});
    EXPECT_EQ(opened.volume->grid.dims.z, 5);
    EXPECT_LT(slicesOf(*opened.volume)[4] - slicesOf(*opened.volume)[0], 6.0) << "a slice of the other volume";
    EXPECT_TRUE(saysAny(opened.warnings, "1 slice missing"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, DicomParts, ::testing::ValuesIn(rowsThatAlwaysPart()),
                         [](const auto& test) { return test.param.name; });

class DicomRepeats : public ::testing::TestWithParam<PartRow> {};

TEST_P(DicomRepeats, OfTheSamePlacesAreTimePoints) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 4; ++i)
    for (const bool second : {true, false}) write(folder, GetParam(), second, i + (second ? 4 : 0), 2.0 * i);
  for (const int time : {1, 2}) {
    const io::OpenedVolume opened = io::openVolume(folder, {.time = time});
    EXPECT_EQ(slicesOf(*opened.volume), time == 1 ? firstValues : (std::vector<double>{24, 25, 26, 27}));
    EXPECT_TRUE(saysAny(opened.warnings, "told apart by"));
  }
}

TEST_P(DicomRepeats, OfOneEvenVolumeDoNotPartIt) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 4; ++i)
    for (const bool second : {false, true}) write(folder, GetParam(), second, i, 2.0 * i + (second ? 8.0 : 0.0));
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims.z, 8);
  EXPECT_TRUE(opened.otherSeries.empty());
  EXPECT_TRUE(opened.warnings.empty());
}

TEST_P(DicomRepeats, ThatInterleaveEvenlyDoNotPartTheVolume) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 4; ++i)
    for (const bool second : {false, true}) write(folder, GetParam(), second, i, 2.0 * i + (second ? 1.0 : 0.0));
  EXPECT_EQ(io::openVolume(folder).volume->grid.dims.z, 8);
}

TEST_P(DicomRepeats, ThatInterleaveUnevenlyAreTwoVolumes) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 4; ++i)
    for (const bool second : {false, true}) write(folder, GetParam(), second, i, 2.0 * i + (second ? 0.7 : 0.0));
  expectBoth(folder);
  EXPECT_TRUE(saysAny(io::openVolume(folder).warnings, "2 interleaved volumes, told apart by"));
}

TEST_P(DicomRepeats, ThatShareOnePlaceAreOneVolume) {
  const fs::path folder = scratchFolder();
  for (int i = 0; i < 4; ++i)
    for (const bool second : {false, true}) write(folder, GetParam(), second, i, 2.0 * i + (second ? 6.0 : 0.0));
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims.z, 7);
  EXPECT_TRUE(saysAny(opened.warnings, "1 slice left out"));
}

INSTANTIATE_TEST_SUITE_P(All, DicomRepeats, ::testing::ValuesIn(rowsThatPartRepeats()),
                         [](const auto& test) { return test.param.name; });

namespace {

/// Sixteen times of five slices but the slices that `missing` names; `numbered`: each with its acquisition number.
fs::path fourD(const fs::path& folder, bool numbered, const std::function<bool(int time, int slice)>& missing) {
  fs::create_directories(folder);
  for (int time = 0; time < 16; ++time)
    for (int slice = 0; slice < 5; ++slice) {
      if (missing(time, slice)) continue;
      DicomSpec spec;
      spec.instance = "1.2." + std::to_string(100 * time + slice + 1);
      spec.instanceNumber = 5 * time + slice + 1;
      spec.acquisitionNumber = numbered ? time + 1 : 1;
      spec.position = glm::dvec3(0, 0, 2 * slice);
      spec.words.assign(12, static_cast<std::uint32_t>(10 * time + slice));
      writeDicom(folder / spec.instance, spec);
    }
  return folder;
}

void expectTimes(const fs::path& folder, int whole) {
  for (int time = 1; time <= whole; ++time) {
    const double first = 10.0 * (time - 1);
    EXPECT_EQ(slicesOf(*io::openVolume(folder, {.time = time}).volume),
              (std::vector<double>{first, first + 1, first + 2, first + 3, first + 4}));
  }
}

}  // namespace

TEST(DicomFourD, ThatWasBrokenOffKeepsItsWholeVolumes) {
  for (const bool numbered : {true, false}) {
    const fs::path folder = fourD(scratchFolder() / (numbered ? "a" : "b"), numbered,
                                  [](int time, int slice) { return time == 15 && slice > 1; });
    expectTimes(folder, 15);
    const io::OpenedVolume last = io::openVolume(folder, {.time = 16});
    EXPECT_EQ(slicesOf(*last.volume), (std::vector<double>{150, 151}));
    EXPECT_TRUE(saysAny(last.warnings, "1 of 16 volumes lacks slices: number 16 has 2 of 5 slices"));
  }
}

TEST(DicomFourD, WithoutASliceOfOneTimeKeepsTheOthersOfIt) {
  const fs::path folder = fourD(scratchFolder(), true, [](int time, int slice) { return time == 2 && slice == 3; });
  const io::OpenedVolume third = io::openVolume(folder, {.time = 3, .regularise = io::Regularise::Off});
  EXPECT_EQ(slicesOf(*third.volume), (std::vector<double>{20, 21, 22, 24}));
  EXPECT_TRUE(saysAny(third.warnings, "1 slice missing"));
  EXPECT_EQ(slicesOf(*io::openVolume(folder, {.time = 4}).volume), (std::vector<double>{30, 31, 32, 33, 34}));
}

TEST(DicomFourD, OfSeveralEchoesHasTheTimesOfEach) {
  const fs::path folder = scratchFolder();
  for (int echo = 0; echo < 2; ++echo)
    for (int time = 0; time < 3; ++time)
      for (int slice = 0; slice < 4; ++slice) {
        DicomSpec spec;
        spec.modality = "MR";
        spec.instance = "1.2." + std::to_string(100 * echo + 10 * time + slice + 1);
        spec.instanceNumber = slice + 1;
        spec.acquisitionNumber = time + 1;
        spec.position = glm::dvec3(0, 0, 2 * slice);
        spec.words.assign(12, static_cast<std::uint32_t>(100 * echo + 10 * time + slice));
        writeEdited(folder / spec.instance, spec, {set(0x00180081, "DS", echo == 0 ? "5" : "10")});
      }
  const std::vector<io::SeriesInfo> series = io::listSeries(folder);
  ASSERT_EQ(series.size(), 6u);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double first = 100.0 * static_cast<double>(i / 3) + 10.0 * static_cast<double>(i % 3);
    EXPECT_EQ(series[i].times, 3);
    EXPECT_EQ(series[i].part, i < 3 ? "echo time 5 ms" : "echo time 10 ms");
    EXPECT_EQ(slicesOf(*io::openVolume(folder, {.series = series[i].id}).volume),
              (std::vector<double>{first, first + 1, first + 2, first + 3}));
  }
}

TEST(DicomFlipAngle, OfEachSliceItsOwnDoesNotPartThem) {
  const fs::path folder = series(
      6, [](int, DicomSpec& spec) { spec.modality = "MR"; }, {},
      [](int slice) { return std::vector{set(0x00181314, "DS", std::to_string(10 + slice))}; })(scratchFolder());
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims.z, 6);
  EXPECT_TRUE(opened.warnings.empty());
}

}  // namespace fenestra::tests::dicomPartsTest
