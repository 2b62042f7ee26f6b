// Small inputs of kinds that people have reported, against their true values (`hard` in the test data).

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;
using io::Warning;

TEST(HardInputs, NrrdInMicrometresHasTheTrueValuesAndPlace) {
  FENESTRA_TEST_DATA_OR_SKIP(truth, "hard/expected/nrrd.nii.gz");
  const io::OpenedVolume expected = io::openVolume(truth);
  for (const char* name : {"hard/nrrd/microns.nrrd", "hard/nrrd/micron-latin1.nrrd"}) {
    FENESTRA_TEST_DATA_OR_SKIP(path, name);
    const io::OpenedVolume opened = io::openVolume(path);
    expectSameGrid(opened.volume->grid, expected.volume->grid, 1e-4);
    EXPECT_EQ(realValues(*opened.volume), realValues(*expected.volume)) << name;
    EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  }
}

TEST(HardInputs, LabelsHaveTheNamesAndColoursOfTheirTables) {
  FENESTRA_TEST_DATA_OR_SKIP(labels, "hard/labels");
  const Grid grid = io::openVolume(labels / "volume.nii").volume->grid;
  const auto snap = io::openLabels(labels / "itksnap.nii.gz", grid).labels;
  ASSERT_NE(snap->find(1), nullptr);
  EXPECT_EQ(snap->find(1)->name, "Left tumour core");
  EXPECT_EQ(snap->find(1)->colour, glm::dvec3(1, 0, 0));
  EXPECT_EQ(snap->find(3)->name, "Hidden one");
  EXPECT_EQ(snap->find(3)->colour, glm::dvec3(0, 0, 1));
  const auto surfer = io::openLabels(labels / "freesurfer.nii.gz", grid).labels;
  EXPECT_EQ(surfer->find(2)->name, "Left-Cerebral-Cortex");
  EXPECT_EQ(surfer->find(3)->name, "Left Lateral Ventricle");
  EXPECT_EQ(surfer->find(3)->colour, glm::dvec3(120, 18, 134) / 255.0);
}

TEST(HardInputs, AnSpmMaskIsALabelMapOfOneLabel) {
  FENESTRA_TEST_DATA_OR_SKIP(labels, "hard/labels");
  const io::OpenedVolume volume = io::openVolume(labels / "volume.nii");
  const io::OpenedLabels opened = io::openLabels(labels / "spm-mask.nii", volume.volume->grid);
  const io::OpenedVolume mask = io::openVolume(labels / "spm-mask.nii");
  std::vector<int> expected;
  for (const double value : realValues(*mask.volume)) expected.push_back(value > 0.5 ? 1 : 0);
  EXPECT_EQ(valuesOf(*opened.labels), expected);
  EXPECT_EQ(opened.labels->labels.size(), 1u);
  EXPECT_NEAR(mask.volume->range.high, 1.0, 1e-6);
}

TEST(HardInputs, AFolderOfMasksIsOneLabelMapNamedAfterTheFiles) {
  FENESTRA_TEST_DATA_OR_SKIP(masks, "hard/labels-segmentations");
  FENESTRA_TEST_DATA_OR_SKIP(volume, "hard/labels/volume.nii");
  const Grid grid = io::openVolume(volume).volume->grid;
  const io::OpenedLabels opened = io::openLabels(masks, grid);
  ASSERT_EQ(opened.labels->labels.size(), 3u);
  std::vector<int> covered(grid.voxelCount(), 0);
  int number = 0;
  for (const char* name : {"kidney_left", "liver", "spleen"}) {
    ++number;
    EXPECT_EQ(opened.labels->find(static_cast<std::uint16_t>(number))->name, name);
    const auto mask = realValues(*io::openVolume(masks / (std::string(name) + ".nii.gz")).volume);
    const auto values = valuesOf(*opened.labels);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      EXPECT_TRUE(values[i] != number || mask[i] > 0.0) << name;
      covered[i] += mask[i] > 0.0;
    }
  }
  const auto values = valuesOf(*opened.labels);
  for (std::size_t i = 0; i < covered.size(); ++i) EXPECT_EQ(values[i] != 0, covered[i] != 0);
  EXPECT_EQ(io::labelFiles(masks).size(), 3u);
}

TEST(HardInputs, AStructureSetWithOneWrongCountOpensWithoutThatContour) {
  FENESTRA_TEST_DATA_OR_SKIP(series, "hard/rtstruct-ct");
  FENESTRA_TEST_DATA_OR_SKIP(plan, "hard/rtstruct");
  const Grid grid = io::openVolume(series).volume->grid;
  const io::OpenedLabels whole = io::openLabels(plan / "plain.dcm", grid),
                         opened = io::openLabels(plan / "one-wrong-point-count.dcm", grid);
  EXPECT_TRUE(whole.warnings.empty()) << kindsOf(whole.warnings);
  ASSERT_EQ(opened.warnings.size(), 1u);
  EXPECT_NE(opened.warnings.front().text.find("1 contour left out"), std::string::npos) << opened.warnings.front().text;
  EXPECT_NE(opened.warnings.front().text.find("box has 4 points but says 7"), std::string::npos);
  // Its neighbours' planes reach half a plane into the gap.
  const auto all = valuesOf(*whole.labels), left = valuesOf(*opened.labels);
  EXPECT_EQ(opened.labels->labels.size(), whole.labels->labels.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(left[i] == 0 || left[i] == all[i]) << i;
}

}  // namespace fenestra::tests
