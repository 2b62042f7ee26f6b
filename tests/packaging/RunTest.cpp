// packaging/run without a display, in a folder of its own with stand-ins for what it calls: where the picture goes.

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/packaging/Shell.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace {

namespace fs = std::filesystem;

class RunScript : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(root_ / "packaging");
    fs::copy_file(FENESTRA_SOURCE_DIR "/packaging/run", root_ / "packaging" / "run");
    standIn("packaging/setup", "exit 0");
    standIn("bin/cmake", "exit 0");
    standIn("build/release/app/fenestra-cli", "printf '<%s>' \"$@\"");
    standIn("build/release/app/viewer/fenestra", "printf 'window<%s>' \"$@\"");
  }
  void TearDown() override { fs::remove_all(root_); }

  void standIn(const std::string& place, const std::string& does) const {
    fs::create_directories((root_ / place).parent_path());
    std::ofstream(root_ / place) << "#!/bin/sh\n" << does << "\n";
    fs::permissions(root_ / place, fs::perms::owner_all);
  }
  Outcome run(const std::string& arguments, const std::string& before = {}) const {
    return shell(before + " PATH='" + (root_ / "bin").string() + "':\"$PATH\" '" +
                 (root_ / "packaging" / "run").string() + "' " + arguments);
  }

  const fs::path root_ = scratchFolder();
};

TEST_F(RunScript, DrawsThePhantomWithoutADisplay) {
  const std::string picture = (root_ / "build/release/fenestra.png").string();
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.output,
            "<render><--phantom><torso><-o><" + picture + ">No display: the picture is in " + picture + "\n");
}

TEST_F(RunScript, DrawsIntoTheFileOfScreenshot) {
  EXPECT_EQ(run("'my head' --screenshot 'a b.png' --w-open 40").output,
            "<render><my head><--w-open><40><-o><a b.png>No display: the picture is in a b.png\n");
  EXPECT_EQ(run("--screenshot=c.png").output,
            "<render><--phantom><torso><-o><c.png>No display: the picture is in c.png\n");
}

TEST_F(RunScript, RefusesAScreenshotWithoutAFile) {
  const Outcome outcome = run("head --screenshot");
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_EQ(outcome.output, "packaging/run: --screenshot needs the name of a file\n");
}

TEST_F(RunScript, HandsTheScreenshotToTheWindow) {
  EXPECT_EQ(run("head --screenshot w.png", "DISPLAY=:7").output, "window<head>window<--screenshot>window<w.png>");
}

TEST_F(RunScript, FailsWhereThePictureCannotBeDrawn) {
  standIn("build/release/app/fenestra-cli", "exit 1");
  const Outcome outcome = run("head --screenshot w.png");
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.output, "");
}

}  // namespace
}  // namespace fenestra::tests
