// The man pages that packaging/man-pages makes of --help.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/packaging/Shell.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace {

TEST(ManPages, HoldEveryOptionAndAreMadeWithoutADisplay) {
  if (!isInstalled("help2man")) GTEST_SKIP() << "help2man is not installed";
  const std::filesystem::path folder = scratchFolder();
  std::string making = FENESTRA_SOURCE_DIR "/packaging/man-pages " + folder.string();
  for (const Program& program : programs()) making += " " + program.path;
  const Outcome made = shell("export SOURCE_DATE_EPOCH=86400; " + making);
  ASSERT_EQ(made.exitCode, 0) << made.output;

  for (const Program& program : programs()) {
    EXPECT_TRUE(std::filesystem::exists(folder / (program.name + ".1")));
    for (const std::string& command : program.commands) {
      const std::string name = program.name + (command.empty() ? "" : "-" + command);
      std::string page = contentsOf((folder / (name + ".1")).string());
      EXPECT_NE(page.find("\"January 1970\""), std::string::npos) << name << " has a date of its own";
      EXPECT_NE(page.find("\n.SH NAME\n" + name + " \\- "), std::string::npos) << page.substr(0, 300);
      std::erase(page, '\\');
      for (const std::string& option : optionsInHelp(program, command))
        EXPECT_NE(page.find("fB" + option + "fR"), std::string::npos) << name << " lacks " << option;
    }
  }
}

}  // namespace
}  // namespace fenestra::tests
