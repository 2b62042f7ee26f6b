#pragma once
// Shared by the io tests: files of known bytes, the form of errors, and volumes compared voxel by voxel.

#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"

namespace fenestra::tests {

void writeFile(const std::filesystem::path& path, const std::string& bytes);
std::string readFile(const std::filesystem::path& path);

/// The bytes of `value` in this machine's order, or the other one.
template <class T>
std::string bytesOf(T value, bool swapped = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return swapped ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}
template <class T>
std::string bytesOf(const std::vector<T>& values, bool swapped = false) {
  std::string bytes;
  for (const T value : values) bytes += bytesOf(value, swapped);
  return bytes;
}

std::string gzipped(const std::string& bytes);
std::string zlibbed(const std::string& bytes);
std::string bzipped(const std::string& bytes);

/// Every real value, x fastest.
std::vector<double> realValues(const Volume& volume);
/// The text of the io::Error that `act` throws; a test failure and "" when it throws none.
std::string errorOf(const std::function<void()>& act);
bool hasWarning(const std::vector<io::Warning>& warnings, io::Warning::Kind kind);
/// The first warning of the kind; a test failure and an empty one when there is none.
io::Warning warningOf(const std::vector<io::Warning>& warnings, io::Warning::Kind kind);
std::string kindsOf(const std::vector<io::Warning>& warnings);

/// Fails the test where the grids differ by more than `millimetres` at a corner.
void expectSameGrid(const Grid& actual, const Grid& expected, double millimetres);

}  // namespace fenestra::tests
