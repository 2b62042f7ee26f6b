// No function of the product is longer than a screen, and no file longer than can be read in one go.

#include <algorithm>
#include <iostream>

#include <gtest/gtest.h>

#include "tests/layers/Sizes.h"

namespace fenestra::tests {
namespace {

constexpr int mostFunctionLines = 60, mostFileLines = 500;
const std::vector<std::string_view> endings{".h", ".cpp", ".comp", ".glsl", ".vert", ".frag"};

/// Prints the five longest, and fails for each that is longer than `most`.
void expectWithin(int most, std::vector<Length> lengths) {
  std::stable_sort(lengths.begin(), lengths.end(), [](const Length& a, const Length& b) { return a.lines > b.lines; });
  for (std::size_t i = 0; i < std::min<std::size_t>(5, lengths.size()); ++i)
    std::cout << "  " << lengths[i].lines << "  " << lengths[i].where << "\n";
  for (const Length& each : lengths)
    if (each.lines > most) ADD_FAILURE() << each.where << " has " << each.lines << " lines, more than " << most;
}

TEST(Sizes, FunctionsAreShort) {
  std::vector<Length> lengths;
  for (const SourceFile& source : productSources(endings))
    for (const Length& length : functionLengths(source)) lengths.push_back(length);
  EXPECT_GT(lengths.size(), 1000u) << "the functions were not found";
  expectWithin(mostFunctionLines, std::move(lengths));
}

TEST(Sizes, FilesAreShort) {
  std::vector<Length> lengths;
  for (const SourceFile& source : productSources(endings)) lengths.push_back({source.path, lineCount(source)});
  EXPECT_GT(lengths.size(), 200u) << "the sources were not found";
  expectWithin(mostFileLines, std::move(lengths));
}

// The following tests feed made-up sources to the checks.

std::vector<std::pair<std::string, int>> functionsIn(const std::string& text) {
  std::vector<std::pair<std::string, int>> found;
  for (const Length& length : functionLengths({"F.cpp", text})) found.emplace_back(length.where, length.lines);
  return found;
}
using Found = std::vector<std::pair<std::string, int>>;

TEST(SizesCheck, MeasuresFunctionsFromDeclarationToBrace) {
  EXPECT_EQ(functionsIn("int f() { return 1; }\n"), (Found{{"F.cpp:1 f", 1}}));
  EXPECT_EQ(
      functionsIn("namespace a {\nnamespace {\n\nvoid g(int x,\n       int y) {\n  if (x) {\n    y();\n  }\n}\n}\n}\n"),
      (Found{{"F.cpp:4 g", 6}}));
}

TEST(SizesCheck, CountsMembersConstructorsAndReturnedTypes) {
  const std::string text =
      "class A : public B {\n public:\n  A(int x) : x_(x), y_{x} {\n    start();\n  }\n"
      "  int x() const noexcept override {\n    return x_;\n  }\n"
      "  auto z() -> std::vector<int> {\n    return {};\n  }\n\n private:\n  int x_ = 0, y_{1};\n};\n";
  EXPECT_EQ(functionsIn(text), (Found{{"F.cpp:3 A", 3}, {"F.cpp:6 x", 3}, {"F.cpp:9 z", 3}}));
}

TEST(SizesCheck, IsNotMisledByTextsCommentsMacrosOrInitialisers) {
  const std::string text =
      "#define OPEN {\n// void no() {\nconst char* brace = \"{\";\nconst char quote = '{';\n"
      "const std::array<int, 2> pair{{1, f(2)}};\nstruct P {\n  int a;\n};\nenum class E : int { A, B };\n"
      "int h() {\n  return 1'000 + '}';\n}\n";
  EXPECT_EQ(functionsIn(text), (Found{{"F.cpp:10 h", 3}}));
}

TEST(SizesCheck, ReadsShaders) {
  const std::string text =
      "layout(local_size_x = 8) in;\nlayout(std430, binding = 2) buffer Views {\n  vec4 views[];\n};\n"
      "vec4 colourAt(vec3 p) {\n  return vec4(p, 1.0);\n}\nvoid main() {\n}\n";
  EXPECT_EQ(functionsIn(text), (Found{{"F.cpp:5 colourAt", 3}, {"F.cpp:8 main", 2}}));
}

TEST(SizesCheck, FindsAFunctionOfManyLines) {
  std::string text = "void longOne() {\n";
  for (int i = 0; i < mostFunctionLines; ++i) text += "  step();\n";
  const Found found = functionsIn(text + "}\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].second, mostFunctionLines + 2);
}

}  // namespace
}  // namespace fenestra::tests
