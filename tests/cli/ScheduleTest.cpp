// The schedule of the shaders: tried once, kept, overridden, and never a reason to fail.

#include <sys/wait.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/ImageWriter.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::scheduleTest {
namespace {

namespace fs = std::filesystem;

class ScheduleCommand : public ::testing::Test {
 protected:
  void SetUp() override { ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1); }

  int render(const std::string& options) const {
    const std::string command =
        std::string(FENESTRA_CLI) + " render --phantom torso --phantom-voxels 48 --size 80x70 " + "-o '" +
        at("picture.png") + "' --stats '" + at("stats.json") + "' " + options + " 2>'" + at("error") + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  fs::path answers() const { return folder_ / "cache" / "fenestra" / "schedules.json"; }
  std::string used() const { return nlohmann::json::parse(std::ifstream(at("stats.json")))["schedule"]; }

 private:
  const fs::path folder_ = scratchFolder();
};

TEST_F(ScheduleCommand, Thorough_TheFasterOneIsFoundOnceAndKept) {
  ASSERT_EQ(render(""), 0);
  const nlohmann::json kept = nlohmann::json::parse(std::ifstream(answers()));
  ASSERT_EQ(kept.size(), 1u);
  const std::string key = kept.begin().key();
  const nlohmann::json answer = kept.begin().value();
  EXPECT_NE(key.find("int16"), std::string::npos) << "the voxels' type is part of " << key;
  const bool plain = answer["plain_ms"] <= answer["llvmpipe_ms"];
  EXPECT_EQ(answer["schedule"], plain ? "plain" : "llvmpipe");
  EXPECT_EQ(used(), answer["schedule"]);
  // The trial is not repeated: the kept answer is followed, whatever it says.
  nlohmann::json turned = kept;
  turned[key]["schedule"] = plain ? "llvmpipe" : "plain";
  std::ofstream(answers()) << turned;
  ASSERT_EQ(render(""), 0);
  EXPECT_EQ(used(), turned[key]["schedule"]);
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(answers())), turned);
}

TEST_F(ScheduleCommand, Thorough_TheOptionOverridesAndDrawsTheSamePicture) {
  ASSERT_EQ(render("--schedule plain"), 0);
  EXPECT_EQ(used(), "plain");
  EXPECT_FALSE(fs::exists(answers())) << "nothing was tried";
  const io::Picture plain = io::readPicture(at("picture.png"));
  ASSERT_EQ(render("--schedule llvmpipe"), 0);
  EXPECT_EQ(used(), "llvmpipe");
  EXPECT_EQ(io::readPicture(at("picture.png")).values, plain.values);
  EXPECT_EQ(render("--schedule fast"), 2);
}

TEST_F(ScheduleCommand, Thorough_ADamagedOrUnwritableFileCostsATrialAndNothingElse) {
  fs::create_directories(answers().parent_path());
  std::ofstream(answers()) << R"({"a": [1, 2)";
  ASSERT_EQ(render(""), 0);
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(answers())).size(), 1u);
  fs::remove_all(answers().parent_path());
  std::ofstream(answers().parent_path()) << "a file where the folder should be";
  EXPECT_EQ(render(""), 0);
}

}  // namespace
}  // namespace fenestra::tests::scheduleTest
