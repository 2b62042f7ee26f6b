// fenestra-cli render --edges, as a script uses it.

#include "io/session/SessionFile.h"
#include "tests/cli/CommandLine.h"
#include "tests/cli/PictureCommand.h"

namespace fenestra::tests::edgesCommandTest {
namespace {

class EdgesCommand : public CommandLine {
 protected:
  Result render(const std::string& name, const std::vector<std::string>& more) const {
    std::vector<std::string> all{"render",         "--phantom",   "torso",  "--phantom-voxels", "64",
                                 "--focus-labels", "left kidney", "--size", "120x100",          "--camera",
                                 "200,10",         "-o",          at(name)};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
  double shareBeyond(double limit, const std::string& a, const std::string& b) const {
    return tests::shareBeyond(limit, at(a), at(b));
  }
};

TEST_F(EdgesCommand, Thorough_PicturesAreTheReferencesAndOffIsTheDefault) {
  ASSERT_EQ(render("plain.png", {"--max-error", "1"}).exitCode, 0);
  ASSERT_EQ(render("off.png", {"--max-error", "1", "--edges", "off"}).exitCode, 0);
  ASSERT_EQ(render("smooth.png", {"--max-error", "1", "--edges", "smooth"}).exitCode, 0);
  ASSERT_EQ(render("truth.png", {"--edges", "smooth", "--reference"}).exitCode, 0);
  EXPECT_EQ(contents(at("off.png")), contents(at("plain.png")));
  // A bound of 1/255 and two 8-bit roundings, except where rays graze a surface.
  EXPECT_LT(shareBeyond(2.0, "smooth.png", "truth.png"), 0.002);
  EXPECT_GT(shareBeyond(5.0, "plain.png", "truth.png"), 0.02) << "the test would notice";
}

TEST_F(EdgesCommand, DraftsHaveNone) {
  ASSERT_EQ(render("a.png", {"--quality", "draft"}).exitCode, 0);
  ASSERT_EQ(render("b.png", {"--quality", "draft", "--edges", "smooth"}).exitCode, 0);
  EXPECT_EQ(contents(at("a.png")), contents(at("b.png")));
}

TEST_F(EdgesCommand, ACertificateIsOfTheSmoothPicture) {
  const Result result = render("a.png", {"--max-error", "1", "--edges", "smooth", "--certify", "12000"});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_EQ(result.json().at("pixels"), 120 * 100);
  EXPECT_EQ(result.json().at("within"), 1.0);
  EXPECT_GT(result.json().at("share"), 0.998);
}

TEST_F(EdgesCommand, ASessionKeepsIt) {
  ASSERT_EQ(render("a.png", {"--edges", "smooth", "--save-session", at("work.fenestra")}).exitCode, 0);
  EXPECT_EQ(io::readSession(at("work.fenestra")).look.edges, Edges::Smooth);
  ASSERT_EQ(run({"render", at("work.fenestra"), "-o", at("b.png")}).exitCode, 0);
  EXPECT_EQ(contents(at("a.png")), contents(at("b.png")));
  EXPECT_EQ(render("x.png", {"--edges", "soft"}).exitCode, 2);
}

}  // namespace
}  // namespace fenestra::tests::edgesCommandTest
