// fenestra-cli render --carve and --bend, and sessions that keep them.

#include "io/session/SessionFile.h"
#include "tests/cli/PictureCommand.h"

namespace fenestra::tests::removalCommandTest {
namespace {

using RemovalCommand = PictureCommand;

/// In the phantom's mm, where the camera of PictureCommand sees them.
const std::vector<std::string> removals{"--carve 'ball:40,120,0:75:6'", "--carve 'box:40,120,0;60,110,30:110,80,120'",
                                        "--carve 'box:40,120,0:120,130,80:5:0.3,-1,0.2:0,0,1'",
                                        "--carve 'saw:90,130,-60;80,140,60:0.3,-1,0:80:50'",
                                        "--bend '120,40,-60;-60,60,-50;20,60,80:0,1,0:drag=20,50,0,-25,60'"};

TEST_F(RemovalCommand, Thorough_PicturesAreTheReferences) {
  ASSERT_EQ(render("whole.png", "--method sculpt"), 0);
  for (const std::string& removal : removals) {
    SCOPED_TRACE(removal);
    ASSERT_EQ(render("here.png", "--method sculpt " + removal), 0);
    ASSERT_EQ(render("truth.png", "--method sculpt --reference " + removal), 0);
    // A bound of 1/255 and two 8-bit roundings.
    EXPECT_LT(shareBeyond(2.0, "here.png", "truth.png"), 0.005);
    EXPECT_GT(shareBeyond(2.0, "whole.png", "truth.png"), 0.02) << "the test would notice";
  }
}

TEST_F(RemovalCommand, Thorough_ActWithEveryMethodAndMethodsOfRemovalsOpenNothing) {
  for (const std::string method : {"adaptive", "clearview", "context-preserving"}) {
    ASSERT_EQ(render("whole.png", "--method " + method), 0);
    ASSERT_EQ(render("carved.png", "--method " + method + " " + removals[0]), 0);
    EXPECT_GT(shareBeyond(2.0, "whole.png", "carved.png"), 0.02) << method;
  }
  ASSERT_EQ(render("closed.png", "--cutaway off"), 0);
  for (const std::string method : {"sculpt", "bend"}) {
    ASSERT_EQ(render("plain.png", "--method " + method), 0);
    EXPECT_EQ(bytes("plain.png"), bytes("closed.png")) << method;
  }
}

TEST_F(RemovalCommand, ASessionKeepsThemAndNoneDropsThem) {
  std::string all = "--method sculpt";
  for (const std::string& removal : removals) all += " " + removal;
  ASSERT_EQ(render("a.png", all + " --save-session " + quoted("work.fenestra")), 0);
  const Look kept = io::readSession(at("work.fenestra")).look;
  ASSERT_EQ(kept.removals.size(), removals.size());
  EXPECT_EQ(kept.removals[4].bends.size(), 1u);
  const std::string again = "render " + quoted("work.fenestra") + " -o ";
  ASSERT_EQ(run(again + quoted("b.png")), 0);
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
  ASSERT_EQ(run(again + quoted("bent.png") + " --carve none --save-session " + quoted("bent.fenestra")), 0);
  EXPECT_EQ(io::readSession(at("bent.fenestra")).look.removals.size(), 1u) << "the plane is --bend's";
  ASSERT_EQ(run(again + quoted("c.png") + " --carve none --bend none"), 0);
  ASSERT_EQ(render("whole.png", "--method sculpt"), 0);
  EXPECT_EQ(bytes("c.png"), bytes("whole.png"));
}

TEST_F(RemovalCommand, AFocusThatIsCarvedAwayLeavesAPicture) {
  ASSERT_EQ(render("x.png", "--carve ball:0,0,0:2000"), 0);
  ASSERT_EQ(render("x.png", "--method sculpt --carve ball:0,0,0:2000"), 0);
}

TEST_F(RemovalCommand, RefusesWhatRemovesNothing) {
  for (const std::string wrong : {"--carve ball",
                                  "--carve ball:1,2,3",
                                  "--carve ball:1,2:5",
                                  "--carve ball:1,2,3:0",
                                  "--carve ball:1,2,3:-4",
                                  "--carve ball:1,2,nan:4",
                                  "--carve ball:1,2,3:4:-1",
                                  "--carve ball:1,2,3:4:1:1",
                                  "--carve cone:1,2,3:4",
                                  "--carve plane:1,2,3:4",
                                  "--carve box:1,2,3:4,5",
                                  "--carve box:1,2,3:4,5,0",
                                  "--carve box:1,2,3:4,5,6:0:1,0,0",
                                  "--carve box:1,2,3:4,5,6:0:1,0,0:2,0,0",
                                  "--carve saw:1,2,3:0,1,0:5",
                                  "--carve saw:1,2,3:0,0,0:5:2",
                                  "--bend 1,2,3",
                                  "--bend 1,2,3:0,0,0",
                                  "--bend 1,2,3:0,0,1:drag=1,2,3,4",
                                  "--bend 1,2,3:0,0,1:drag=1,2,3,4,0",
                                  "--bend '1,2,3;;4,5,6:0,0,1'"})
    EXPECT_EQ(render("x.png", wrong), 2) << wrong;
  EXPECT_FALSE(std::filesystem::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests::removalCommandTest
