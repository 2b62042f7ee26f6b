// dciodvfy (dicom3tools) says nothing of a copy that it does not say of the original, on the real objects.

#include <cstdio>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "io/deidentify/Deidentify.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::deidentify_validator {
namespace {

namespace fs = std::filesystem;

bool hasValidator() { return std::system("command -v dciodvfy >/dev/null 2>&1") == 0; }

/// The lines of errors about a file, without what stands in its values.
std::set<std::string> errorsIn(const fs::path& file, const fs::path& log) {
  [[maybe_unused]] const int status =
      std::system(("dciodvfy '" + file.string() + "' > '" + log.string() + "' 2>&1").c_str());
  std::ifstream lines(log);
  std::set<std::string> errors;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("Error")) errors.insert(line.substr(0, line.find("= <")));
  return errors;
}

class DeidentifyValidator : public ::testing::Test {
 protected:
  /// The copy of each object on its own, so that it is known which is which.
  void check(const fs::path& file, const io::deidentify::Options& options) {
    SCOPED_TRACE(file.string());
    const fs::path out = folder_ / "out";
    fs::remove_all(out);
    try {
      io::deidentify::deidentify({.inputs = {file}, .output = out, .options = options});
    } catch (const io::Error& error) {
      // An object that says neither what nor which it is; both are what a copy is known by.
      EXPECT_NE(std::string(error.what()).find("does not say which object"), std::string::npos) << error.what();
      return;
    }
    ++checked_;
    fs::path copy;
    for (const auto& entry : fs::recursive_directory_iterator(out))
      if (entry.is_regular_file()) copy = entry.path();
    const std::set<std::string> before = errorsIn(file, folder_ / "log"), after = errorsIn(copy, folder_ / "log");
    for (const std::string& error : after) EXPECT_TRUE(before.contains(error)) << error;
  }

  const fs::path folder_ = scratchFolder();
  int checked_ = 0;
};

TEST_F(DeidentifyValidator, Thorough_FindsNoNewErrorInRealObjects) {
  if (!hasValidator()) GTEST_SKIP() << "needs dciodvfy, of the package dicom3tools";
  FENESTRA_TEST_DATA_OR_SKIP(data, "dicom");
  std::set<fs::path> folders;
  for (const auto& entry : fs::recursive_directory_iterator(data)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".dcm") continue;
    // One of a series; all of the folder whose files differ in kind.
    const fs::path parent = entry.path().parent_path();
    if (parent.filename() != "pixel-formats" && !folders.insert(parent).second) continue;
    check(entry.path(), {});
    check(entry.path(), {true, true, true, true});
  }
  EXPECT_GT(checked_, 20);
}

}  // namespace
}  // namespace fenestra::tests::deidentify_validator
