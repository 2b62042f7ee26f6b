// Completion in each shell, as the shell itself finds it, against what --help lists.

#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>

#include <gtest/gtest.h>

#include "tests/packaging/Shell.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace {

class Completion : public ::testing::Test {
 protected:
  /// The script of a program, in a file.
  std::string script(const Program& program, const std::string& name) const {
    const Outcome made = shell(program.path + " --completion " + name);
    EXPECT_EQ(made.exitCode, 0) << made.output;
    const std::string path = (folder_ / (program.name + "." + name)).string();
    std::ofstream(path) << made.output;
    return path;
  }

  /// The first group of `pattern` in every line of `output` that matches.
  static std::set<std::string> matches(const std::string& output, const std::string& pattern) {
    std::set<std::string> found;
    const std::regex expression(pattern);
    for (const std::string& line : linesOf(output)) {
      std::smatch match;
      if (std::regex_match(line, match, expression)) found.insert(match[1]);
    }
    return found;
  }

  /// Expects that `complete`, given a program's command and the beginning of a word, offers every long option of --help
  /// and no other.
  void expectAllOptions(const std::function<std::set<std::string>(const Program&, const std::string&)>& complete) {
    for (const Program& program : programs()) {
      ASSERT_FALSE(program.commands.empty());
      for (const std::string& command : program.commands) {
        const std::set<std::string> options = optionsInHelp(program, command);
        EXPECT_GE(options.size(), 1u) << program.name << " " << command;
        EXPECT_EQ(complete(program, command), options) << program.name << " " << command;
      }
    }
  }

  const std::filesystem::path folder_ = scratchFolder();
};

std::string inBash(const std::string& script, const std::string& words, int count) {
  return "bash -c 'source " + script + "; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(count - 1) +
         "; _${COMP_WORDS[0]}; printf \"%s\\n\" \"${COMPREPLY[@]}\"'";
}

TEST_F(Completion, InBashOffersTheOptionsOfHelp) {
  expectAllOptions([&](const Program& program, const std::string& command) {
    const std::string words = program.name + " " + command + " --";
    return matches(shell(inBash(script(program, "bash"), words, command.empty() ? 2 : 3)).output, "(--.*)");
  });
}

TEST_F(Completion, InBashOffersCommandsAndTheWordsOfAnOption) {
  const Program cli = programs().front();
  const std::string path = script(cli, "bash");
  const std::set<std::string> commands(cli.commands.begin(), cli.commands.end());
  EXPECT_EQ(matches(shell(inBash(path, "fenestra-cli \"\"", 2)).output, "(.*)"), commands);
  EXPECT_EQ(matches(shell(inBash(path, "fenestra-cli render --shading \"\"", 4)).output, "(.*)"),
            (std::set<std::string>{"on", "off"}));
  std::ofstream(folder_ / "volume.nii") << "";
  const std::string file = (folder_ / "volume.nii").string();
  EXPECT_EQ(matches(shell(inBash(path, "fenestra-cli render " + file.substr(0, file.size() - 3), 3)).output, "(.*)"),
            std::set<std::string>{file});
}

TEST_F(Completion, InZshOffersTheOptionsOfHelp) {
  if (!isInstalled("zsh")) GTEST_SKIP() << "zsh is not installed";
  // The specifications that zsh's own _arguments gets.
  expectAllOptions([&](const Program& program, const std::string& command) {
    const std::string run = "zsh -f -c '_arguments() { print -rl -- \"$@\" }; compdef() { : }; source " +
                            script(program, "zsh") + "; words=(" + program.name + " " + command +
                            " --); CURRENT=$#words; _" + program.name + "'";
    return matches(shell(run).output, R"((?:\*|\([^)]*\))(--[a-z-]+)\[.*)");
  });
}

TEST_F(Completion, InFishOffersTheOptionsOfHelp) {
  if (!isInstalled("fish")) GTEST_SKIP() << "fish is not installed";
  expectAllOptions([&](const Program& program, const std::string& command) {
    const std::string run = "HOME=" + folder_.string() + " fish --no-config -c 'source " + script(program, "fish") +
                            "; complete -C \"" + program.name + " " + command + " --\"'";
    return matches(shell(run).output, R"((--[a-z-]+)\t.*)");
  });
}

TEST_F(Completion, OfAnUnknownShellIsRefused) {
  for (const Program& program : programs()) {
    const Outcome refused = shell(program.path + " --completion ksh");
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_EQ(refused.output, program.name + ": --completion: \"ksh\" is not bash|zsh|fish; see --help\n");
  }
}

}  // namespace
}  // namespace fenestra::tests
