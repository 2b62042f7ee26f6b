// fenestra-cli render --occlusion and --shadow, as a script uses them.

#include "io/session/SessionFile.h"
#include "tests/cli/PictureCommand.h"

namespace fenestra::tests::occlusionCommandTest {
namespace {

using OcclusionCommand = PictureCommand;

TEST_F(OcclusionCommand, PicturesAreTheReferences) {
  const std::string both = "--occlusion 0.9 --shadow 0.8 --light=-40,50 ";
  ASSERT_EQ(render("plain.png", ""), 0);
  ASSERT_EQ(render("both.png", both), 0);
  ASSERT_EQ(render("truth.png", both + "--reference"), 0);
  // A bound of 1/255 and two 8-bit roundings, except where the opening's rim grazes a surface.
  EXPECT_LT(shareBeyond(2.0, "both.png", "truth.png"), 0.01);
  EXPECT_GT(shareBeyond(2.0, "plain.png", "truth.png"), 0.1) << "the test would notice";
  ASSERT_EQ(render("off.png", "--occlusion 0 --shadow 0"), 0);
  EXPECT_EQ(bytes("off.png"), bytes("plain.png"));
}

TEST_F(OcclusionCommand, ASessionKeepsBoth) {
  ASSERT_EQ(render("a.png", "--occlusion 0.35 --shadow 0.6 --save-session " + quoted("work.fenestra")), 0);
  const io::Session session = io::readSession(at("work.fenestra"));
  EXPECT_EQ(session.look.shading.occlusion, 0.35);
  EXPECT_EQ(session.look.shading.shadow, 0.6);
  ASSERT_EQ(run("render " + quoted("work.fenestra") + " -o " + quoted("b.png")), 0);
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
}

TEST_F(OcclusionCommand, RefusesWhatIsNoShare) {
  for (const std::string wrong : {"--occlusion 1.1", "--occlusion -0.1", "--shadow nan", "--shadow 2"})
    EXPECT_EQ(render("x.png", wrong), 2) << wrong;
  EXPECT_FALSE(std::filesystem::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests::occlusionCommandTest
