// What readers say is shown by the window as well as by the command line, so options are named in one file alone.

#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/layers/Sources.h"

namespace fenestra::tests {
namespace {

/// The places of string literals that name an option of the command line.
std::vector<std::string> optionsNamedIn(const SourceFile& source) {
  // Behind a quote, a blank or a bracket; "--help" is every program's own.
  static const std::regex named(R"re("([^"\\]|\\.)*--(?!help)[a-z][^"]*")re");
  std::vector<std::string> found;
  std::istringstream lines(source.text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (std::regex_search(line, named)) found.push_back(source.path + ":" + std::to_string(number));
  }
  return found;
}

TEST(Texts, OptionsAreNamedByTheTableOfWaysOutAlone) {
  int named = 0;
  for (const SourceFile& source : productSources({".h", ".cpp"})) {
    if (!source.path.starts_with("io/") && !source.path.starts_with("viewer/")) continue;
    for (const std::string& place : optionsNamedIn(source)) {
      ++named;
      EXPECT_EQ(source.path, "io/base/WayOut.cpp") << place << " names an option; add a row to WayOut.h for it";
    }
  }
  EXPECT_GT(named, 10) << "the table was not found";
}

TEST(TextsCheck, FindsOptionsInTextsAlone) {
  EXPECT_EQ(optionsNamedIn({"a.cpp", "int a;\nsay(\"leave out --time\");\n"}), std::vector<std::string>{"a.cpp:2"});
  EXPECT_TRUE(optionsNamedIn({"a.cpp", "--i; // as --time does\nsay(\"a -- b\");\nsay(\"see --help\");\n"}).empty());
}

}  // namespace
}  // namespace fenestra::tests
