// The user guide's files: links and pictures lead somewhere, nothing is left over, and options are those of the
// programs. Links of the project's other pages, and how long those are that everybody reads first.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>

#include <gtest/gtest.h>

#include "tests/packaging/Shell.h"

namespace fenestra::tests {
namespace {

namespace fs = std::filesystem;

const fs::path guide = fs::path(FENESTRA_SOURCE_DIR) / "resources" / "guide";

std::vector<fs::path> pages(const fs::path& folder = guide) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// As GitHub names a heading of ASCII letters.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char each : heading)
    if (std::isalnum(static_cast<unsigned char>(each)) || each == '-')
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(each)));
    else if (each == ' ')
      anchor += '-';
  return anchor;
}

std::set<std::string> anchorsIn(const fs::path& page) {
  std::set<std::string> anchors;
  for (const std::string& line : linesOf(contentsOf(page.string())))
    if (line.starts_with("#")) anchors.insert(anchorOf(line.substr(line.find_first_not_of("# "))));
  return anchors;
}

struct Link {
  bool isPicture;
  std::string text, target;
};
/// Links outside of blocks of code, where brackets mean something else.
std::vector<Link> linksIn(const fs::path& page) {
  std::string text;
  bool isCode = false;
  for (const std::string& line : linesOf(contentsOf(page.string()))) {
    if (line.starts_with("```")) isCode = !isCode;
    if (!isCode) text += line + '\n';
  }
  const std::regex link(R"((!?)\[([^\]]*)\]\(([^)]*)\))");
  std::vector<Link> links;
  for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found)
    links.push_back({(*found)[1].length() > 0, (*found)[2], (*found)[3]});
  return links;
}

/// The faults of a page's links to files, a line each. The guide links nothing else, because it is read offline.
std::string brokenLinks(const fs::path& page) {
  std::string broken;
  for (const Link& link : linksIn(page)) {
    if (page.parent_path() != guide && link.target.starts_with("https://")) continue;
    const std::string file = link.target.substr(0, link.target.find('#'));
    const fs::path target = file.empty() ? page : page.parent_path() / file;
    if (!fs::is_regular_file(target)) {
      broken += page.filename().string() + ": " + link.target + " is no file\n";
    } else if (const std::size_t hash = link.target.find('#'); hash != std::string::npos) {
      if (!anchorsIn(target).contains(link.target.substr(hash + 1)))
        broken += page.filename().string() + ": " + link.target + " has no such heading\n";
    }
    if (link.isPicture && link.text.empty()) broken += page.filename().string() + ": a picture without words\n";
  }
  return broken;
}

TEST(GuideText, LinksLeadSomewhere) {
  std::size_t links = 0;
  for (const fs::path& page : pages()) {
    EXPECT_EQ(brokenLinks(page), "");
    links += linksIn(page).size();
  }
  EXPECT_GT(links, 25u);
}

TEST(GuideText, TheCheckOfLinksFindsBrokenOnes) {
  const fs::path folder = fs::temp_directory_path() / "fenestra-guide-links";
  fs::create_directories(folder);
  const fs::path page = folder / "page.md";
  std::ofstream(page) << "# One Heading\n[a](#one-heading) [b](#two) [c](none.md) ![](page.md)\n";
  EXPECT_EQ(brokenLinks(page),
            "page.md: #two has no such heading\npage.md: none.md is no file\npage.md: a picture without words\n");
  fs::remove_all(folder);
}

TEST(GuideText, LinksOfTheProjectsOtherPagesLeadSomewhere) {
  const fs::path root = FENESTRA_SOURCE_DIR;
  std::vector<fs::path> found = pages(root);
  for (const char* folder : {"io", "packaging", "rendering", "resources", "tests", "viewer"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".md" && entry.path().parent_path() != guide) found.push_back(entry.path());
  for (const fs::path& page : found) {
    SCOPED_TRACE(page);
    EXPECT_EQ(brokenLinks(page), "");
  }
  EXPECT_GT(found.size(), 15u);
}

TEST(GuideText, WhatEverybodyReadsFirstIsShort) {
  EXPECT_LE(contentsOf(FENESTRA_SOURCE_DIR "/README.md").size(), 9000u);
  EXPECT_LE(contentsOf(FENESTRA_SOURCE_DIR "/CONTRIBUTING.md").size(), 10000u);
}

TEST(GuideText, EveryPageIsInTheIndexAndEveryPictureInAPage) {
  std::set<std::string> listed{"index.md"}, shown;
  for (const Link& link : linksIn(guide / "index.md")) listed.insert(link.target);
  std::set<std::string> files;
  for (const fs::path& page : pages()) {
    files.insert(page.filename().string());
    for (const Link& link : linksIn(page))
      if (link.isPicture) shown.insert(link.target);
  }
  EXPECT_EQ(listed, files);
  std::set<std::string> pictures;
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(guide / "images")) {
    pictures.insert("images/" + entry.path().filename().string());
    bytes += entry.file_size();
  }
  EXPECT_EQ(shown, pictures);
  EXPECT_LE(bytes, 1'500'000u) << "the pictures are part of the program";
}

TEST(GuideText, TheProgramHoldsEveryPageAndPicture) {
  const std::string listed = contentsOf(FENESTRA_SOURCE_DIR "/viewer/guide/guide.qrc");
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(guide)) {
    if (!entry.is_regular_file()) continue;
    const std::string file = entry.path().lexically_relative(guide).generic_string();
    EXPECT_NE(listed.find("<file alias=\"" + file + "\">../../resources/guide/" + file + "</file>"), std::string::npos)
        << file;
  }
}

TEST(GuideText, OptionsAndCommandsAreThoseOfThePrograms) {
  std::set<std::string> options{"--help"}, commands;
#ifndef FENESTRA_WINDOW
  options.insert("--screenshot");  // of the window's program alone
  options.insert("--language");
#endif
  for (const Program& program : programs()) {
    options.merge(optionsInHelp(program, ""));
    for (const std::string& command : program.commands) {
      options.merge(optionsInHelp(program, command));
      commands.insert(command);
    }
  }
  std::size_t checked = 0;
  for (const fs::path& page : pages()) {
    const std::string text = contentsOf(page.string());
    const std::regex option(" (--[a-z][a-z-]*)"), command("fenestra-cli ([a-z]+)");
    for (std::sregex_iterator found(text.begin(), text.end(), option), end; found != end; ++found, ++checked)
      EXPECT_TRUE(options.contains((*found)[1])) << page.filename() << " names " << (*found)[1];
    for (std::sregex_iterator found(text.begin(), text.end(), command), end; found != end; ++found, ++checked)
      EXPECT_TRUE(commands.contains((*found)[1])) << page.filename() << " names " << (*found)[1];
  }
  EXPECT_GT(checked, 20u);
}

}  // namespace
}  // namespace fenestra::tests
