// The table of defects through fenestra-cli: exit code, one line on standard error, time and memory.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/io/Defects.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::defectsCommandTest {
namespace fs = std::filesystem;

namespace {

struct Ended {
  int exitCode = -1;  ///< -1: ended by a signal
  double seconds = 0.0;
  std::uint64_t bytes = 0;  ///< the most memory in use
  std::string out, error;
};

/// `fenestra-cli` with its output in `logs`.
Ended run(std::vector<std::string> words, const fs::path& logs) {
  words.insert(words.begin(), FENESTRA_CLI);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const fs::path out = logs.string() + ".out", error = logs.string() + ".error";
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    const auto redirect = [](const fs::path& file, int descriptor) {
      ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), descriptor);
    };
    redirect(out, STDOUT_FILENO);
    redirect(error, STDERR_FILENO);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  Ended ended;
  ended.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ended.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  ended.bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // in kilobytes on Linux
  ended.out = readFile(out);
  ended.error = readFile(error);
  return ended;
}

[[maybe_unused]] std::uint64_t bytesIn(const fs::path& folder) {  // with AddressSanitizer nothing is compared
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) bytes += entry.file_size();
  return bytes;
}

}  // namespace

class DefectsCommandTable : public ::testing::TestWithParam<Defect> {};

TEST_P(DefectsCommandTable, Thorough_EndsWithTheCodeAndTheLineThatTheTableSays) {
  const Defect& defect = GetParam();
  const fs::path folder = scratchFolder();
  fs::path path;
  try {
    path = defect.make(folder);
  } catch (const MissingTestData& missing) {
    GTEST_SKIP() << "needs the test-data file " << missing.what();
  }
  const Ended ended = run(defect.command(path), folder.string());
  EXPECT_LT(ended.seconds, 10.0);
#if !defined(__SANITIZE_ADDRESS__)  // keeps freed memory
  EXPECT_LT(ended.bytes, bytesIn(folder) + 300'000'000);
#endif
  if (defect.expected.outcome == Outcome::Error) {
    EXPECT_EQ(ended.exitCode, 1) << ended.error;
    EXPECT_EQ(std::count(ended.error.begin(), ended.error.end(), '\n'), 1) << ended.error;
    EXPECT_TRUE(ended.error.starts_with("fenestra-cli: " + folder.string())) << ended.error;
    EXPECT_NE(ended.error.find(defect.expected.says), std::string::npos) << ended.error;
    EXPECT_EQ(ended.out, "");
    return;
  }
  EXPECT_EQ(ended.exitCode, 0) << ended.error;
  if (!defect.labelsOf.empty()) {  // `convert` warns on standard error
    EXPECT_NE(ended.error.find(defect.expected.says), std::string::npos) << ended.error;
    EXPECT_EQ(ended.error.empty(), defect.expected.outcome == Outcome::Opens) << ended.error;
    return;
  }
  EXPECT_EQ(ended.error, "");
  const nlohmann::json report = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << ended.out;
  for (int axis = 0; defect.spacing && axis < 3; ++axis)
    EXPECT_NEAR(report.at("spacing").at(static_cast<std::size_t>(axis)).get<double>(), (*defect.spacing)[axis],
                1e-6 * (*defect.spacing)[axis]);
  const nlohmann::json& warnings = report.at("warnings");
  EXPECT_EQ(std::any_of(warnings.begin(), warnings.end(),
                        [&](const nlohmann::json& warning) {
                          return warning.at("text").get<std::string>().find(defect.expected.says) != std::string::npos;
                        }),
            defect.expected.outcome == Outcome::Warning)
      << warnings.dump(1);
}

INSTANTIATE_TEST_SUITE_P(All, DefectsCommandTable, ::testing::ValuesIn(allDefects()),
                         [](const auto& test) { return testNameOf(test.param); });

TEST(DefectsCommand, HeadersMayNameFilesOutsideWhenTheUserAllowsIt) {
  const fs::path folder = scratchFolder();
  fs::create_directories(folder / "inner");
  writeFile(folder / "voxels.raw", std::string(8, '\x05'));
  const fs::path header = folder / "inner" / "a.mhd";
  writeFile(header,
            "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nElementDataFile = "
            "../voxels.raw\n");
  const Ended refused = run({"info", header.string()}, folder / "refused");
  EXPECT_EQ(refused.exitCode, 1);
  EXPECT_NE(refused.error.find("--allow-outside"), std::string::npos) << refused.error;
  const Ended allowed = run({"info", header.string(), "--allow-outside"}, folder / "allowed");
  EXPECT_EQ(allowed.exitCode, 0) << allowed.error;
}

}  // namespace fenestra::tests::defectsCommandTest
