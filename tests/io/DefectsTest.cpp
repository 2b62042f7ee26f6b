// Every row of the table of defects, opened in this process.

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/Defects.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

std::string textsOf(const std::vector<io::Warning>& warnings) {
  std::string texts;
  for (const io::Warning& warning : warnings) texts += "\n  " + warning.text;
  return texts;
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
    const io::OpenedVolume opened = io::openVolume(path, defect.options());
    EXPECT_NE(defect.expected.outcome, Outcome::Error) << "no error, but" << textsOf(opened.warnings);
    if (defect.expected.outcome == Outcome::Opens) {
      EXPECT_TRUE(opened.warnings.empty()) << textsOf(opened.warnings);
    } else {
      EXPECT_TRUE(std::any_of(
          opened.warnings.begin(), opened.warnings.end(),
          [&](const io::Warning& warning) { return warning.text.find(defect.expected.says) != std::string::npos; }))
          << "no warning of '" << defect.expected.says << "', but" << textsOf(opened.warnings);
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

}  // namespace fenestra::tests
