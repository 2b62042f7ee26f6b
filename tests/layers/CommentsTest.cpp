// A comment is a sentence with a subject. One that begins with "Of" or "The same" has its subject somewhere else.

#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/layers/Sources.h"

namespace fenestra::tests {
namespace {

struct Comments {
  int count = 0;
  std::vector<std::string> withoutSubject;  ///< their places
};

/// Comments that begin with // or more. Lines of comment that follow each other are one; what stands behind code is its
/// own.
Comments commentsIn(const SourceFile& source) {
  static const std::regex begins(R"re((^|\s)//[/!]?<?\s+(\S.*)$)re"), without("(Of|The same)\\b.*"),
      wholeLine("\\s*//.*");
  Comments found;
  std::istringstream lines(source.text);
  int number = 0;
  bool goesOn = false;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    const bool isComment = std::regex_search(line, match, begins);
    const bool isLine = std::regex_match(line, wholeLine);
    if (isComment && !(isLine && goesOn)) {
      ++found.count;
      if (std::regex_match(match[2].str(), without))
        found.withoutSubject.push_back(source.path + ":" + std::to_string(number));
    }
    goesOn = isLine;
  }
  return found;
}

TEST(Comments, BeginWithWhatTheyAreAbout) {
  std::vector<SourceFile> sources = productSources({".h", ".cpp", ".comp", ".glsl", ".vert", ".frag"});
  for (SourceFile& test : sourcesBelow("tests", {".h", ".cpp"})) sources.push_back(std::move(test));
  int count = 0;
  for (const SourceFile& source : sources) {
    const Comments comments = commentsIn(source);
    count += comments.count;
    for (const std::string& place : comments.withoutSubject)
      ADD_FAILURE() << place << ": begin the comment with what it is about";
  }
  EXPECT_GT(count, 5000) << "the comments were not found";
}

TEST(CommentsCheck, FindsThoseWithoutASubjectWhereTheyBegin) {
  const std::string slashes = "//";  // so that these lines hold no comments that this test finds
  const Comments comments =
      commentsIn({"a.h", slashes + "/ Of a label.\nint a;\nint b;  " + slashes + "/< The same, in mm.\n" + slashes +
                             " Sizes in mm.\n" + slashes + " Of labels alone.\nint c;  " + slashes + " of labels\n"});
  EXPECT_EQ(comments.count, 4);
  EXPECT_EQ(comments.withoutSubject, (std::vector<std::string>{"a.h:1", "a.h:3"}));
}

}  // namespace
}  // namespace fenestra::tests
