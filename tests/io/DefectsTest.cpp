// Every row of the table of defects, opened in this process.

#include <algorithm>
#include <cstdio>
#include <set>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/Defects.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::defectsTest {
namespace fs = std::filesystem;

namespace {

std::string textsOf(const std::vector<io::Warning>& warnings) {
  std::string texts;
  for (const io::Warning& warning : warnings) texts += "\n  " + commandLineText(warning);
  return texts;
}

/// "#rrggbb"
std::string hexOf(const glm::dvec3& colour) {
  char text[8];
  const glm::ivec3 bytes(glm::round(colour * 255.0));
  std::snprintf(text, sizeof text, "#%02x%02x%02x", bytes.x & 255, bytes.y & 255, bytes.z & 255);
  return text;
}

/// The warnings when the row's file is opened: a volume's warnings, or those of the labels on their volume's grid.
std::vector<io::Warning> warningsOf(const Defect& defect, const fs::path& path) {
  if (defect.labelsOf.empty()) {
    const io::OpenedVolume opened = io::openVolume(path, defect.options());
    for (int axis = 0; defect.spacing && axis < 3; ++axis)
      EXPECT_NEAR(opened.volume->grid.spacing[axis], (*defect.spacing)[axis], 1e-6 * (*defect.spacing)[axis]);
    return opened.warnings;
  }
  const Grid grid = io::openVolume(path.parent_path() / defect.labelsOf).volume->grid;
  const fs::path table = defect.labelTable.empty() ? fs::path() : path.parent_path() / defect.labelTable;
  const io::OpenedLabels opened = io::openLabels(path, grid, {}, false, table);
  std::set<std::string> named;
  for (const Label& label : opened.labels->labels) {
    const std::string text = std::to_string(label.value) + " " + label.name;
    named.insert(text);
    named.insert(text + " " + hexOf(label.colour));
  }
  for (const std::string& name : defect.labelNames) EXPECT_TRUE(named.contains(name)) << name;
  return opened.warnings;
}

}  // namespace

class Defects : public ::testing::TestWithParam<Defect> {};

TEST_P(Defects, GiveTheErrorOrWarningThatTheTableSays) {
  const Defect& defect = GetParam();
  fs::path path;
  try {
    path = defect.make(scratchFolder());
  } catch (const MissingTestData& missing) {
    GTEST_SKIP() << "needs the test-data file " << missing.what();
  }
  testing::internal::CaptureStderr();
  try {
    const std::vector<io::Warning> warnings = warningsOf(defect, path);
    EXPECT_NE(defect.expected.outcome, Outcome::Error) << "no error, but" << textsOf(warnings);
    if (defect.expected.outcome == Outcome::Opens) {
      EXPECT_TRUE(warnings.empty()) << textsOf(warnings);
    } else {
      EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                              [&](const io::Warning& warning) {
                                return commandLineText(warning).find(defect.expected.says) != std::string::npos;
                              }))
          << "no warning of '" << defect.expected.says << "', but" << textsOf(warnings);
    }
  } catch (const io::Error& error) {
    EXPECT_EQ(defect.expected.outcome, Outcome::Error) << error.what();
    const std::string text = error.what();
    EXPECT_NE(text.find(defect.expected.says), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_FALSE(error.hint().empty()) << text;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

INSTANTIATE_TEST_SUITE_P(All, Defects, ::testing::ValuesIn(allDefects()),
                         [](const auto& test) { return testNameOf(test.param); });

TEST(DefectTable, HasManyKindsEachOfItsOwn) {
  std::set<std::string> names;
  for (const Defect& defect : allDefects()) EXPECT_TRUE(names.insert(testNameOf(defect)).second) << defect.name;
  EXPECT_GE(names.size(), 120u);
}

}  // namespace fenestra::tests::defectsTest
