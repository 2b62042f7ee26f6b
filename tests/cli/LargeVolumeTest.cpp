// Memory that a volume of 512 × 512 × 2000 voxels (1 GB) takes. Writes gigabytes and takes a minute, so it runs only
// where FENESTRA_LARGE_TESTS is set.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/io/DicomWriter.h"
#include "tests/support/LargeVolume.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::largeVolumeTest {
namespace {

namespace fs = std::filesystem;

using namespace large;

class LargeVolume : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::getenv("FENESTRA_LARGE_TESTS")) GTEST_SKIP() << "takes a minute; runs where FENESTRA_LARGE_TESTS is set";
    folder_ = scratchFolder();
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  /// Peak resident memory in bytes of fenestra-cli with these arguments; it must succeed.
  double peakOf(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), FENESTRA_CLI);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      if (!std::freopen("/dev/null", "w", stdout)) ::_exit(126);
      ::execv(pointers[0], pointers.data());
      ::_exit(127);
    }
    int status = 0;
    rusage usage{};
    EXPECT_EQ(::wait4(child, &status, 0, &usage), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << arguments[1];
    return static_cast<double>(usage.ru_maxrss) * 1024.0;
  }

  fs::path folder_;
};

TEST_F(LargeVolume, InOneFile) {
  const fs::path file = folder_ / "large.raw";
  writeRaw(file);
  const std::vector<std::string> raw{file, "--raw", "512x512x2000:int16", "--spacing", "0.8,0.8,0.5"};
  const auto with = [&](const char* command, std::vector<std::string> more) {
    std::vector<std::string> arguments{command};
    arguments.insert(arguments.end(), raw.begin(), raw.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  EXPECT_LE(peakOf(with("info", {})), 2.5 * volumeBytes + programBytes);
  EXPECT_LE(peakOf(with("slice", {"-o", folder_ / "slice.png"})), 2.5 * volumeBytes + programBytes);
  // On a software device, textures lie in main memory, too: the voxels once more, and gradients of twice their size.
  EXPECT_LE(peakOf(with("render", {"--size", "200x200", "--schedule", "llvmpipe", "-o", folder_ / "picture.png"})),
            4.0 * volumeBytes + programBytes);
}

TEST_F(LargeVolume, AsADicomSeriesWithAMissingSlice) {
  DicomSpec spec;
  spec.columns = spec.rows = side;
  for (int z = 0; z < slices; ++z) {
    if (z == 700) continue;
    spec.instance = "1.2." + std::to_string(z + 1);
    spec.position = glm::dvec3(0.0, 0.0, 0.5 * z);
    spec.words.clear();
    for (const std::int16_t value : sliceOf(z)) spec.words.push_back(static_cast<std::uint16_t>(value));
    writeDicom(folder_ / std::to_string(z), spec);
  }
  EXPECT_LE(peakOf({"info", folder_, "--regularise", "off"}), 2.5 * volumeBytes + programBytes);
  // The slices as stored and on even planes.
  EXPECT_LE(peakOf({"slice", folder_, "-o", folder_ / "slice.png"}), 2.5 * volumeBytes + programBytes);
}

}  // namespace
}  // namespace fenestra::tests::largeVolumeTest
