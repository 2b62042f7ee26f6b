#pragma once
// Commands of a shell, and what the programs say of their own options.

#include <set>
#include <string>
#include <vector>

namespace fenestra::tests {

struct Outcome {
  int exitCode = -1;  ///< -1: ended by a signal
  std::string output;
};
/// Runs a command of the shell without a display; `output` holds standard output and standard error.
Outcome shell(const std::string& command);

/// Whether a program of this name is installed.
bool isInstalled(const std::string& program);

std::string contentsOf(const std::string& path);
std::vector<std::string> linesOf(const std::string& text);

/// A program, with its commands or with the one empty name where it has none.
struct Program {
  std::string name, path;
  std::vector<std::string> commands;
};
/// fenestra-cli, and fenestra where it is built.
std::vector<Program> programs();

/// The long options that --help of a command lists.
std::set<std::string> optionsInHelp(const Program& program, const std::string& command);

}  // namespace fenestra::tests
