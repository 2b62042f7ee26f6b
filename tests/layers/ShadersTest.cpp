// Shaders are put together from files by #include, not by conditions of the preprocessor (rendering/shaders/README.md).

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/layers/Sources.h"

namespace fenestra::tests {
namespace {

constexpr int mostConditions = 10;
const std::string root = "rendering/shaders/";

std::vector<SourceFile> shaders() {
  std::vector<SourceFile> found;
  for (const SourceFile& source : productSources({".comp", ".vert", ".frag", ".glsl"}))
    if (source.path.starts_with(root)) found.push_back({source.path.substr(root.size()), source.text});
  return found;
}

/// How often a pattern begins a line.
int count(const std::string& text, const std::string& pattern) {
  const std::regex line("^" + pattern);
  int found = 0;
  std::istringstream lines(text);
  for (std::string each; std::getline(lines, each);) found += std::regex_search(each, line);
  return found;
}

TEST(Shaders, HaveFewConditionsOfThePreprocessor) {
  int conditions = 0;
  for (const SourceFile& shader : shaders()) conditions += count(shader.text, R"(\s*#\s*(if|ifdef|ifndef|elif)\b)");
  EXPECT_LE(conditions, mostConditions);
}

TEST(Shaders, HaveOneMainAFileAndNoneInLib) {
  EXPECT_GT(shaders().size(), 100u) << "the shaders were not found";
  for (const SourceFile& shader : shaders())
    EXPECT_EQ(count(shader.text, R"(void main\()"), shader.path.starts_with("lib/") ? 0 : 1) << shader.path;
}

/// A file is included by its path; an alternative by its name, which is that of a folder in lib.
TEST(Shaders, IncludeWhatThereIs) {
  std::set<std::string> files, folders, included;
  for (const SourceFile& shader : shaders()) {
    files.insert(shader.path);
    if (shader.path.starts_with("lib/") && shader.path.find('/', 4) != std::string::npos)
      folders.insert(shader.path.substr(4, shader.path.find('/', 4) - 4));
  }
  const std::regex include(R"#(^#include (["<])(.*)[">]$)#");
  for (const SourceFile& shader : shaders()) {
    std::istringstream lines(shader.text);
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
      if (!std::regex_match(line, found, include)) continue;
      const std::string name = found[2];
      included.insert(name);
      EXPECT_TRUE(found[1] == "<" ? folders.contains(name) : files.contains(name)) << shader.path << ": " << line;
    }
  }
  for (const std::string& file : files)
    if (file.starts_with("lib/") && file.find('/', 4) == std::string::npos) {
      EXPECT_TRUE(included.contains(file)) << file << " is included nowhere";
    }
}

}  // namespace
}  // namespace fenestra::tests
