#pragma once
// The entry points that libFuzzer feeds with bytes: every reader of files that people bring. An io::Error is the right
// answer to bad bytes; any other exception, a sanitizer's report, a hang or too much memory is a finding.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fenestra::fuzz {

struct Target {
  std::string_view name;
  std::string_view file;  ///< what the bytes are called on the disk
  /// Opens the file; throws io::Error at will.
  void (*open)(const std::filesystem::path& file);
};

std::span<const Target> targets();
/// Throws std::out_of_range.
const Target& targetNamed(std::string_view name);

/// A folder's files as one input of the targets that open folders: the size of each in four bytes, little-endian, and
/// its bytes, in the order of their names.
std::string packFolder(const std::filesystem::path& folder);

/// Writes the bytes to the target's file in a private folder and opens it.
void run(const Target& target, std::span<const std::byte> bytes);

/// Small valid files for the target to start from.
std::vector<std::string> seedsOf(const Target& target);

}  // namespace fenestra::fuzz
