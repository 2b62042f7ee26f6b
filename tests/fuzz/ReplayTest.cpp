// Every seed and everything that fuzzing ever found, opened again: the readers answer with a volume or an io::Error.

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/fuzz/Targets.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::fuzz {
namespace fs = std::filesystem;

class Replay : public ::testing::TestWithParam<Target> {};

TEST_P(Replay, SeedsAreGoodFiles) {
  const std::vector<std::string> seeds = seedsOf(GetParam());
  ASSERT_FALSE(seeds.empty());
  const fs::path folder = fs::temp_directory_path() / ("fenestra-replay-" + std::string(GetParam().name));
  fs::create_directories(folder);
  for (const std::string& seed : seeds) {
    tests::writeFile(folder / GetParam().file, seed);
    EXPECT_NO_THROW(GetParam().open(folder / GetParam().file));
  }
  fs::remove_all(folder);
}

TEST_P(Replay, FindingsStayMended) {
  const fs::path corpus = fs::path(FENESTRA_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name;
  if (!fs::exists(corpus)) return;
  for (const auto& entry : fs::directory_iterator(corpus)) {
    const std::string bytes = tests::readFile(entry.path());
    SCOPED_TRACE(entry.path().filename());
    EXPECT_NO_THROW(run(GetParam(), std::as_bytes(std::span(bytes))));
  }
}

/// Otherwise what is fuzzed would be a refusal.
TEST(ReplayProvider, TakesTheObjectsOfItsSeeds) {
  const Target& target = targetNamed("provider");
  const fs::path folder = tests::scratchFolder();
  for (const std::string& seed : seedsOf(target)) {
    tests::writeFile(folder / target.file, seed);
    target.open(folder / target.file);
    std::size_t files = 0;
    for (const auto& each : fs::recursive_directory_iterator(folder / "received"))
      files += each.path().extension() == ".dcm" ? 1 : 0;
    EXPECT_EQ(files, 1u);
  }
}

TEST(ReplayCommitment, TakesTheReportsOfItsSeeds) {
  const Target& target = targetNamed("commitment");
  const fs::path folder = tests::scratchFolder();
  std::vector<std::string> verdicts;
  for (const std::string& seed : seedsOf(target)) {
    tests::writeFile(folder / target.file, seed);
    target.open(folder / target.file);
    verdicts.push_back(tests::readFile(folder / "verdict"));
  }
  const std::string failed = "the server has no such object.";
  EXPECT_EQ(verdicts, (std::vector<std::string>{".", ".", failed, failed}));
}

// Every truncation of every seed, as a fuzzer's first round would try it.
TEST_P(Replay, TruncatedSeedsNeverCrash) {
  for (const std::string& seed : seedsOf(GetParam()))
    for (std::size_t size = 0; size < seed.size(); size += 1 + seed.size() / 40)
      EXPECT_NO_THROW(run(GetParam(), std::as_bytes(std::span(seed).first(size))));
}

INSTANTIATE_TEST_SUITE_P(Targets, Replay, ::testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& given) {
                           std::string name(given.param.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace fenestra::fuzz
