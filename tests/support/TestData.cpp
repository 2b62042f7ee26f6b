#include "tests/support/TestData.h"

#include <cstdlib>
#include <string>
#include <unistd.h>

namespace fenestra::tests {
namespace fs = std::filesystem;

fs::path findTestData(const fs::path& relative) {
  const char* env = std::getenv("FENESTRA_TEST_DATA");
  const fs::path root = env ? fs::path(env) : fs::path(FENESTRA_SOURCE_DIR).parent_path() / "shared" / "data";
  const fs::path path = root / relative;
  return fs::exists(path) ? path : fs::path();
}

fs::path unpackTestData(const fs::path& archive, const fs::path& folder) {
  const fs::path packed = findTestData(archive);
  if (packed.empty()) return {};
  const fs::path root = fs::path(FENESTRA_BINARY_DIR) / "test-data";
  const fs::path target = root / folder;
  if (fs::exists(target)) return target;
  // Unpack beside and rename, so that tests run in parallel never see half a folder.
  const fs::path staging = root / ("unpacking-" + std::to_string(::getpid()));
  fs::create_directories(staging);
  const std::string command = "tar -xJf '" + packed.string() + "' -C '" + staging.string() + "'";
  if (std::system(command.c_str()) != 0) return {};
  std::error_code raced;
  fs::rename(staging / folder, target, raced);
  fs::remove_all(staging);
  return fs::exists(target) ? target : fs::path();
}

fs::path scratchFolder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  for (char& c : name)
    if (c == '/') c = '_';
  const fs::path path = fs::path(FENESTRA_BINARY_DIR) / "test-scratch" / name;
  fs::remove_all(path);
  fs::create_directories(path);
  return path;
}

}  // namespace fenestra::tests
