#pragma once
// Runs the fenestra-cli binary as a user or a script does.

#include <sys/wait.h>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/TestData.h"

namespace fenestra::tests {

namespace fs = std::filesystem;
using Json = nlohmann::json;

inline std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

inline std::string randomBytes(std::size_t count) {
  std::mt19937 engine(7);
  std::string bytes(count, '\0');
  for (char& c : bytes) c = static_cast<char>(engine() & 0xff);
  return bytes;
}

struct Result {
  int exitCode = -1;  ///< -1: ended by a signal
  std::string out, error;
  Json json() const { return Json::parse(out, nullptr, false); }
};

class CommandLine : public ::testing::Test {
 protected:
  Result run(const std::vector<std::string>& arguments) const {
    std::string command = quoted(FENESTRA_CLI);
    for (const std::string& argument : arguments) command.append(" ").append(quoted(argument));
    const fs::path out = logs_ / "out", error = logs_ / "error";
    command.append(" >").append(quoted(out)).append(" 2>").append(quoted(error)).append(" </dev/null");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(error)};
  }

  /// Exit code 1 and one line on standard error that names the program and `path`.
  static void expectFailure(const Result& result, const std::string& path) {
    EXPECT_EQ(result.exitCode, 1) << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_TRUE(result.error.starts_with("fenestra-cli: " + path + ": ")) << result.error;
  }

  fs::path folder() const { return folder_; }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  bool nothingLeftBehind() const { return fs::is_empty(folder_); }

 private:
  static std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
  }
  static fs::path made(const fs::path& path) {
    fs::create_directories(path);
    return path;
  }

  const fs::path scratch_ = tests::scratchFolder();
  const fs::path logs_ = made(scratch_ / "logs");
  const fs::path folder_ = made(scratch_ / "files");
};

}  // namespace fenestra::tests
