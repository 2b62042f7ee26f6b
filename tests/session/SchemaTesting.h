#pragma once
// Files against a published schema.

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fenestra::tests {

/// The mistakes that python3-jsonschema finds in files by a schema; members that the schema does not name are mistakes,
/// too.
inline std::vector<std::string> mistakesIn(const std::filesystem::path& schema,
                                           const std::vector<std::filesystem::path>& files) {
  std::string command = "python3 '" FENESTRA_VALIDATE "' '" + schema.string() + "'";
  for (const std::filesystem::path& file : files) command += " '" + file.string() + "'";
  std::vector<std::string> mistakes;
  FILE* output = ::popen(command.c_str(), "r");
  std::array<char, 4096> line;
  while (std::fgets(line.data(), line.size(), output)) mistakes.emplace_back(line.data());
  EXPECT_EQ(::pclose(output), 0) << "python3 with the package python3-jsonschema is needed";
  return mistakes;
}

}  // namespace fenestra::tests
