// A driver that fails ends fenestra-cli with one line and exit code 1.

#include <sys/wait.h>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/TestData.h"

namespace fenestra::tests::failingDriverTest {
namespace {

struct Ended {
  int code = -1;  ///< -1 when ended by a signal
  std::string errors;
};

/// Runs fenestra-cli on a driver that fails in `what`.
Ended run(const std::string& what, const std::string& arguments) {
  const std::filesystem::path errors = scratchFolder() / "errors";
  const std::string command = "LD_PRELOAD='" FENESTRA_FAILING_DRIVER "' FENESTRA_FAILING_DRIVER=" + what +
                              " '" FENESTRA_CLI "' " + arguments + " --phantom torso --phantom-voxels 32 2>'" +
                              errors.string() + "'";
  const int status = std::system(command.c_str());
  std::ifstream file(errors);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, {std::istreambuf_iterator<char>(file), {}}};
}

void expectOneLine(const Ended& ended, const std::string& part) {
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
  EXPECT_NE(ended.errors.find(part), std::string::npos) << ended.errors;
  EXPECT_EQ(ended.errors.find("unexpected"), std::string::npos) << ended.errors;
}

TEST(FailingDriver, RefusesShaders) {
  const std::string picture = (scratchFolder() / "picture.png").string();
  const Ended ended = run("shaders", "render --size 60x50 -o '" + picture + "'");
  expectOneLine(ended, "the graphics driver refuses a shader");
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(FailingDriver, RefusesShadersThatMeasureCandidates) {
  expectOneLine(run("shaders", "place --samples 12"), "the graphics driver refuses a shader");
}

TEST(FailingDriver, HasNoMemory) {
  const std::string picture = (scratchFolder() / "picture.png").string();
  expectOneLine(run("memory", "render --size 60x50 -o '" + picture + "'"), "no graphics memory");
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(FailingDriver, DrawsWhereNothingFails) {
  const std::string picture = (scratchFolder() / "picture.png").string();
  const Ended ended = run("nothing", "render --size 60x50 -o '" + picture + "'");
  EXPECT_EQ(ended.code, 0) << ended.errors;
  EXPECT_TRUE(std::filesystem::exists(picture));
}

}  // namespace
}  // namespace fenestra::tests::failingDriverTest
