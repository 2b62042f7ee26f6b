#include "tests/packaging/Shell.h"

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace fenestra::tests {

Outcome shell(const std::string& command) {
  const std::string whole = "unset DISPLAY WAYLAND_DISPLAY; { " + command + "\n} 2>&1 </dev/null";
  FILE* pipe = popen(whole.c_str(), "r");
  if (!pipe) throw std::runtime_error("no shell");
  Outcome outcome;
  std::array<char, 4096> bytes;
  while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), pipe))
    outcome.output.append(bytes.data(), count);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.exitCode = WEXITSTATUS(status);
  return outcome;
}

bool isInstalled(const std::string& program) { return shell("command -v " + program).exitCode == 0; }

std::string contentsOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<Program> programs() {
  Program cli{"fenestra-cli", FENESTRA_CLI, {}};
  bool inCommands = false;
  for (const std::string& line : linesOf(shell(cli.path + " --help").output)) {
    const std::regex command("^  ([a-z]+) +.*");
    std::smatch match;
    if (line.starts_with("Subcommands:"))
      inCommands = true;
    else if (inCommands && std::regex_match(line, match, command))
      cli.commands.push_back(match[1]);
  }
  std::vector<Program> all{cli};
#ifdef FENESTRA_WINDOW
  all.push_back({"fenestra", FENESTRA_WINDOW, {""}});
#endif
  return all;
}

std::set<std::string> optionsInHelp(const Program& program, const std::string& command) {
  std::set<std::string> options;
  const std::regex option("^  (-[a-z],)?(--[a-z-]+).*");
  for (const std::string& line : linesOf(shell(program.path + " " + command + " --help").output)) {
    std::smatch match;
    if (std::regex_match(line, match, option)) options.insert(match[2]);
  }
  return options;
}

}  // namespace fenestra::tests
