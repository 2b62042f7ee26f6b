// Each method of the list has its folder, its place in the user guide and in the page of the mathematics, and no folder
// is left out of the list.

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "rendering/methods/Method.h"
#include "tests/layers/Sources.h"

namespace fenestra::tests {
namespace {

TEST(Methods, EachFolderIsOfAMethodOfTheList) {
  std::set<std::string> words, folders;
  for (const Word<MethodKind>& each : wordsOf(MethodKind{})) words.insert(each.word);
  const std::filesystem::path root = std::filesystem::path(FENESTRA_SOURCE_DIR) / "rendering/methods";
  for (const auto& entry : std::filesystem::directory_iterator(root))
    if (entry.is_directory()) folders.insert(entry.path().filename().string());
  EXPECT_EQ(folders, words);
}

TEST(Methods, TheGuideHasARowAndASectionOfEach) {
  const std::string guide = readSource("resources/guide/methods.md");
  for (const Word<MethodKind>& each : wordsOf(MethodKind{})) {
    const std::string name = each.name;
    EXPECT_NE(guide.find("\n| *" + name + "* |"), std::string::npos) << name << " has no row";
    // The page of the opening is that of the adaptive cutaway.
    if (each.value == kindOf<methods::Adaptive>) continue;
    EXPECT_NE(guide.find("\n## " + name + "\n"), std::string::npos) << name << " has no section";
  }
}

TEST(Methods, ThePageOfTheMathematicsNamesEachFolder) {
  const std::string page = readSource("resources/reference/method.md");
  for (const Word<MethodKind>& each : wordsOf(MethodKind{})) {
    if (each.value == kindOf<methods::Adaptive>) continue;  // all of the page
    EXPECT_NE(page.find("`rendering/methods/" + std::string(each.word) + "`"), std::string::npos) << each.word;
  }
}

}  // namespace
}  // namespace fenestra::tests
