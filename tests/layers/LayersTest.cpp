// Every include and every link line follows the arrows in this folder's README.md, and none closes a cycle.

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/layers/Layers.h"

namespace fenestra::tests {
namespace {

const std::vector<std::string_view> codeEndings{".h", ".cpp"};
constexpr const char* rulePage = "tests/layers/README.md";

std::string joined(const std::vector<std::string>& lines, const char* separator = "\n") {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : separator) + line;
  return text;
}

/// The arrows of a rule, as edges.
std::vector<Edge> edgesOf(const LayerRule& rule) {
  std::vector<Edge> edges;
  for (const auto& [from, used] : rule)
    for (const std::string& to : used) edges.push_back({from, to, "the rule"});
  return edges;
}

void print(const char* title, const std::vector<Edge>& edges, const std::vector<std::string>& breaches) {
  std::cout << title << ": " << edges.size() << " edges, " << breaches.size() << " breaches\n";
  for (const Edge& edge : edges) std::cout << "  " << edge.from << " → " << edge.to << "  (" << edge.where << ")\n";
}

TEST(Architecture, IncludesFollowTheRule) {
  const LayerRule rule = layerRule(readSource(rulePage));
  const std::vector<Edge> edges = includeEdges(productSources(codeEndings));
  const std::vector<std::string> found = breaches(rule, edges);
  print("includes", edges, found);
  EXPECT_GT(edges.size(), 40u) << "the sources were not found";
  EXPECT_TRUE(found.empty()) << joined(found);
  EXPECT_EQ(joined(cycleIn(edges), " → "), "");
}

TEST(Architecture, FilesHaveNoCycle) {
  const std::vector<Edge> edges = fileEdges(productSources(codeEndings));
  EXPECT_GT(edges.size(), 1000u) << "the sources were not found";
  EXPECT_EQ(joined(cycleIn(edges), " → "), "");
}

TEST(Architecture, LinkLinesFollowTheRule) {
  const LayerRule rule = layerRule(readSource(rulePage));
  const auto targets = cmakeTargets(productSources({"CMakeLists.txt"}));
  const std::vector<Edge> edges = linkEdges(targets, rule);
  const std::vector<std::string> found = breaches(rule, edges);
  print("link lines", edges, found);
  EXPECT_GT(edges.size(), 30u) << "the targets were not found";
  EXPECT_TRUE(found.empty()) << joined(found);
}

TEST(Architecture, WhatIsIncludedIsLinked) {
  const auto targets = cmakeTargets(productSources({"CMakeLists.txt"}));
  const std::vector<std::string> found = unlinked(targets, includeEdges(productSources(codeEndings)));
  EXPECT_TRUE(found.empty()) << joined(found);
}

/// Qt's file dialogs store the folders that they show, which may be named after a patient; see the file that may.
TEST(Architecture, FileDialogsAreMadeInOneFile) {
  std::vector<std::string> users;
  for (const SourceFile& source : productSources(codeEndings))
    if (source.text.find("QFileDialog") != std::string::npos) users.push_back(source.path);
  EXPECT_EQ(users, std::vector<std::string>{"viewer/panels/FileDialog.cpp"});
}

TEST(Architecture, TheRuleHasNoCycleAndNoUnusedArrow) {
  const LayerRule rule = layerRule(readSource(rulePage));
  EXPECT_EQ(joined(cycleIn(edgesOf(rule)), " → "), "");
  std::vector<Edge> edges = includeEdges(productSources(codeEndings));
  const std::vector<Edge> links = linkEdges(cmakeTargets(productSources({"CMakeLists.txt"})), rule);
  edges.insert(edges.end(), links.begin(), links.end());
  for (const Edge& arrow : edgesOf(rule)) {
    const bool used = std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
      return lineOf(rule, edge.from) == arrow.from && lineOf(rule, edge.to) == arrow.to;
    });
    EXPECT_TRUE(used) << arrow.from << " → " << arrow.to;
  }
}

constexpr const char* madeUpRule =
    "# A project\n```layers\nscene →\ngl → OpenGL, scene\nwindow → gl, Qt\n```\ntext →\n";

/// The row of each room in the drawing that is fenced as ```rooms, from 0 at the top.
std::map<std::string, int> drawnRooms(std::string_view markdown) {
  const std::string_view fence = "```rooms\n";
  const std::size_t begin = markdown.find(fence);
  if (begin == std::string_view::npos) return {};
  std::istringstream drawing(std::string(markdown.substr(begin + fence.size())));
  std::map<std::string, int> rows;
  std::string line;
  for (int row = 0; std::getline(drawing, line) && line != "```"; ++row) {
    std::istringstream words(line);
    for (std::string word; words >> word;)
      if (word != "│" && !rows.emplace(word, row).second) ADD_FAILURE() << word << " is drawn twice";
  }
  return rows;
}

/// Arrows that do not lead down in a drawing, and rooms that it lacks or that there are not.
std::vector<std::string> misdrawn(const LayerRule& rule, const std::map<std::string, int>& rows) {
  std::vector<std::string> found;
  for (const auto& [room, used] : rule) {
    if (!rows.contains(room)) found.push_back(room + " is not drawn");
    for (const std::string& other : used)
      if (rows.contains(room) && rows.contains(other) && rows.at(other) <= rows.at(room))
        found.push_back(room + " → " + other + " does not lead down");
  }
  for (const auto& [room, row] : rows)
    if (!rule.contains(room)) found.push_back(room + " is drawn, and is no room");
  return found;
}

TEST(Architecture, TheDrawingOfRoomsFollowsTheRule) {
  const std::string text = readSource(rulePage);
  EXPECT_EQ(joined(misdrawn(layerRule(text), drawnRooms(text))), "");
}

TEST(ArchitectureCheck, ReportsRoomsThatAreDrawnWrongly) {
  const LayerRule rule = layerRule(madeUpRule);
  EXPECT_TRUE(misdrawn(rule, drawnRooms("```rooms\n window\n gl\n scene\n```\n")).empty());
  EXPECT_EQ(joined(misdrawn(rule, drawnRooms("```rooms\n gl │ window\n garden\n```\n")), "; "),
            "scene is not drawn; window → gl does not lead down; garden is drawn, and is no room");
}

// The following tests feed made-up projects to the checks: a check that reports nothing would prove nothing.

TEST(ArchitectureCheck, ReadsTheRule) {
  const LayerRule rule = layerRule(madeUpRule);
  ASSERT_EQ(rule.size(), 3u);
  EXPECT_TRUE(rule.at("scene").empty());
  EXPECT_EQ(rule.at("gl"), (std::set<std::string>{"OpenGL", "scene"}));
  EXPECT_THROW(layerRule("no block"), std::runtime_error);
  EXPECT_THROW(layerRule("```layers\nscene uses nothing\n```\n"), std::runtime_error);
  EXPECT_THROW(layerRule("```layers\nscene →\nscene → gl\n```\n"), std::runtime_error);
}

TEST(ArchitectureCheck, ReportsABreachWithItsPlace) {
  const std::vector<SourceFile> sources{
      {"scene/Volume.h", "#pragma once\n#include <vector>\n"},
      {"gl/Texture.cpp", "#include <epoxy/gl.h>\n#include \"scene/Volume.h\"\n"},
      {"scene/Volume.cpp", "#include \"scene/Volume.h\"\n\n#include \"gl/Texture.h\"\n"},
      {"scene/Name.h", "#include <QString>\n"},
      {"extra/New.h", "#include \"scene/Volume.h\"\n"}};
  const std::vector<Edge> edges = includeEdges(sources);
  EXPECT_EQ(breaches(layerRule(madeUpRule), edges),
            (std::vector<std::string>{"extra has no line in the rule (extra/New.h:1)",
                                      "scene must not use Qt (scene/Name.h:1)",
                                      "scene must not use gl (scene/Volume.cpp:3)"}));
  EXPECT_EQ(joined(cycleIn(edges), " → "), "scene → gl → scene");
}

TEST(ArchitectureCheck, ReportsLinkLinesThatBreakTheRuleOrAreMissing) {
  const LayerRule rule = layerRule(madeUpRule);
  const auto targets = cmakeTargets({
      {"scene/CMakeLists.txt", "fenestra_library(scene SOURCES Volume.cpp PUBLIC fenestra::window)\n"},
      {"gl/CMakeLists.txt", "# fenestra::window\nfenestra_library(gl SOURCES Texture.cpp PUBLIC fenestra::scene)\n"},
      {"window/CMakeLists.txt", "add_executable(window main.cpp)\ntarget_link_libraries(window PRIVATE Qt6::Core)\n"},
  });
  EXPECT_EQ(breaches(rule, linkEdges(targets, rule)),
            (std::vector<std::string>{"scene must not use window (scene links window)"}));
  EXPECT_EQ(unlinked(targets, {{"gl", "scene", "a"}, {"window", "gl", "window/main.cpp:1"}}),
            (std::vector<std::string>{"window does not link gl (window/main.cpp:1)"}));
}

TEST(ArchitectureCheck, OneLineIsThatOfAllFoldersWithinAFolder) {
  const LayerRule rule = layerRule("```layers\nbase →\nways/* → base\nways → ways/*\n```\n");
  EXPECT_TRUE(breaches(rule, {{"ways/one", "base", "a"}, {"ways", "ways/two", "b"}}).empty());
  EXPECT_EQ(breaches(rule, {{"ways/one", "ways/two", "a"}, {"ways/one", "ways", "b"}, {"other/one", "base", "c"}}),
            (std::vector<std::string>{"ways/one must not use ways/two (a)", "ways/one must not use ways (b)",
                                      "other/one has no line in the rule (c)"}));
}

TEST(ArchitectureCheck, FindsNoCycleWhereThereIsNone) {
  EXPECT_TRUE(cycleIn({{"a", "b", ""}, {"a", "c", ""}, {"b", "c", ""}}).empty());
  EXPECT_EQ(joined(cycleIn({{"a", "b", ""}, {"b", "c", ""}, {"c", "b", ""}}), " "), "b c b");
}

TEST(ArchitectureCheck, FindsCyclesAmongFilesOfAFolder) {
  std::vector<SourceFile> sources{
      {"scene/Look.h", "#include <vector>\n#include \"scene/Edges.h\"\n"},
      {"scene/Look.cpp", "#include \"scene/Look.h\"\n"},
      {"scene/Edges.h", "struct Look;\n// #include \"scene/Walls.h\"\n"},
      {"scene/Edges.cpp", "#include \"scene/Edges.h\"\n#include \"gl/Texture.h\"\n"},
  };
  EXPECT_EQ(fileEdges(sources), (std::vector<Edge>{{"scene/Edges", "gl/Texture", "scene/Edges.cpp:2"},
                                                   {"scene/Look", "scene/Edges", "scene/Look.h:2"}}));
  EXPECT_TRUE(cycleIn(fileEdges(sources)).empty());
  // The circle closes through a .cpp file, which the compiler accepts.
  sources[3].text += "#include \"scene/Look.h\"\n";
  EXPECT_EQ(joined(cycleIn(fileEdges(sources)), " → "), "scene/Edges → scene/Look → scene/Edges");
}

}  // namespace
}  // namespace fenestra::tests
