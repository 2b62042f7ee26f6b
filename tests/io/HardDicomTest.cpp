// Small DICOM inputs of kinds that people report, against their true values and places.

#include <cmath>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::hardDicomTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

/// The volume holds the values of the expected one at the same places in the patient, but for its slices `without`.
void expectAs(const Volume& volume, const std::string& expected, int without = -1) {
  SCOPED_TRACE(expected);
  const fs::path file = findTestData("hard/expected/" + expected + ".nii.gz");
  ASSERT_FALSE(file.empty());
  const auto truth = io::openVolume(file).volume;
  const glm::dmat4 ours = volume.grid.indexFromWorld() * truth->grid.worldFromIndex();
  ASSERT_EQ(volume.grid.voxelCount() +
                (without < 0 ? 0u : truth->grid.voxelCount() / static_cast<std::size_t>(truth->grid.dims.z)),
            truth->grid.voxelCount());
  std::size_t different = 0;
  double farthest = 0.0;
  for (int z = 0; z < truth->grid.dims.z; ++z)
    for (int y = 0; y < truth->grid.dims.y; ++y)
      for (int x = 0; x < truth->grid.dims.x; ++x) {
        if (z == without) continue;
        glm::dvec3 at(ours * glm::dvec4(x, y, z, 1));
        // Without its slice the stack is spread evenly, with both ends where they belong.
        if (without >= 0) at.z = z < without ? z : z - 1;
        const glm::ivec3 index(glm::round(at));
        farthest = std::max(farthest, glm::distance(at, glm::dvec3(index)));
        different += !volume.grid.contains(index) || volume.value(index) != truth->value({x, y, z});
      }
  EXPECT_EQ(different, 0u);
  // NIfTI's places are of single precision.
  EXPECT_LE(farthest, 1e-3);
}

std::string textsOf(const std::vector<Warning>& warnings) {
  std::string all;
  for (const Warning& warning : warnings) all += warning.text + "\n";
  return all;
}

}  // namespace

TEST(HardDicom, NuclearSlicesFollowAgainstTheNormal) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "hard/nm-recon-tomo-negative");
  const io::OpenedVolume opened = io::openVolume(path);
  expectAs(*opened.volume, "nm-recon-tomo-negative");
  EXPECT_EQ(textsOf(opened.warnings), "");
}

TEST(HardDicom, ConeBeamFramesFollowTheFirstAtTheirSpacing) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "hard/cbct-multiframe-spacing-between-slices");
  const io::OpenedVolume opened = io::openVolume(path);
  expectAs(*opened.volume, "cbct-multiframe-spacing-between-slices");
  EXPECT_NE(textsOf(opened.warnings).find("the place of its first frame alone"), std::string::npos);
}

TEST(HardDicom, SliceLocationAloneGivesTheStep) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "hard/cbct-multiframe-slice-location-only");
  const io::OpenedVolume opened = io::openVolume(path);
  EXPECT_NEAR(opened.volume->grid.spacing.z, 2.5, 1e-9);
  EXPECT_NE(textsOf(opened.warnings).find("does not say where its slices lie"), std::string::npos);
}

TEST(HardDicom, SlicesOfOneInstanceUidAreSlicesOfTheirOwn) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "hard/anonymised-uids-one-sop-instance");
  const io::OpenedVolume opened = io::openVolume(path);
  expectAs(*opened.volume, "anonymised-uids-one-sop-instance");
  EXPECT_NE(textsOf(opened.warnings).find("12 files share a SOP Instance UID"), std::string::npos);
}

TEST(HardDicom, DecimalCommasAreReadAsPointsAndSaid) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "hard/number-texts-comma-position");
  const io::OpenedVolume opened = io::openVolume(path);
  expectAs(*opened.volume, "number-texts-comma-position");
  EXPECT_NE(textsOf(opened.warnings).find("written with a comma"), std::string::npos);
}

TEST(HardDicom, PaddingByNulIsPaddingByBlanks) {
  FENESTRA_TEST_DATA_OR_SKIP(nul, "hard/nul-padding-monochrome1-nul");
  FENESTRA_TEST_DATA_OR_SKIP(blank, "hard/nul-padding-monochrome1-blank");
  const auto a = io::openVolume(nul).volume, b = io::openVolume(blank).volume;
  EXPECT_TRUE(a->lowIsWhite);
  EXPECT_TRUE(b->lowIsWhite);
  EXPECT_EQ(realValues(*a), realValues(*b));
}

TEST(HardDicom, ContoursAndColoursPaddedByNulAreKept) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "hard/nul-padding-rt");
  FENESTRA_TEST_DATA_OR_SKIP(ct, "hard/nul-padding-ct");
  const Grid grid = io::openVolume(ct).volume->grid;
  for (const char* name : {"rt.dcm", "rt-colour-nul.dcm"}) {
    SCOPED_TRACE(name);
    const io::OpenedLabels opened = io::openLabels(path / name, grid);
    EXPECT_EQ(textsOf(opened.warnings), "");
    EXPECT_EQ(opened.labels->labels.at(0).colour, glm::dvec3(1, 0, 0));
  }
}

TEST(HardDicom, MagnitudeAndPhaseAreTwoVolumesWithTheirOwnGaps) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "hard/mixed-magnitude-and-phase-two-missing");
  const std::vector<io::SeriesInfo> series = io::listSeries(path);
  ASSERT_EQ(series.size(), 2u);
  const auto open = [&](const io::SeriesInfo& info) {
    return io::openVolume(path, {.series = info.id, .regularise = io::Regularise::Off});
  };
  EXPECT_EQ(series[0].part, "image component magnitude");
  expectAs(*open(series[0]).volume, "magnitude", 3);
  expectAs(*open(series[1]).volume, "phase", 9);
  for (const io::SeriesInfo& info : series)
    EXPECT_NE(textsOf(open(info).warnings).find("1 slice missing"), std::string::npos);
}

}  // namespace fenestra::tests::hardDicomTest
