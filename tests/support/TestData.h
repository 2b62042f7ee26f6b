#pragma once
// Where tests find real data, and where they may write.

#include <filesystem>

#include <gtest/gtest.h>

namespace fenestra::tests {

/// The file or folder of the real-data collection at `relative`; empty when the collection or the file is not there.
/// The collection is $FENESTRA_TEST_DATA, or `shared/data` beside the checkout.
std::filesystem::path findTestData(const std::filesystem::path& relative);

/// As findTestData, for a folder kept as a .tar.xz archive (`archive`): unpacks it once into the build folder and returns
/// the folder `folder` inside it; empty when the archive is not there.
std::filesystem::path unpackTestData(const std::filesystem::path& archive, const std::filesystem::path& folder);

/// A fresh, empty folder for the running test, below the build folder.
std::filesystem::path scratchFolder();

}  // namespace fenestra::tests

/// Binds `variable` to the real file or skips the test with a message that names it.
#define FENESTRA_TEST_DATA_OR_SKIP(variable, relative)                              \
  const std::filesystem::path variable = ::fenestra::tests::findTestData(relative); \
  if (variable.empty()) GTEST_SKIP() << "needs the test-data file " << (relative)
