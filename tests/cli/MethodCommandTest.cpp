// fenestra-cli render --method and the methods' own options, as a script uses them.

#include "io/session/SessionFile.h"
#include "tests/cli/PictureCommand.h"

namespace fenestra::tests::methodCommandTest {
namespace {

using MethodCommand = PictureCommand;

const std::vector<std::string> methods{
    "--method cone --cone-angle 50",
    "--method importance --importance-angle 25",
    "--method importance --importance average --importance-opacity 0.2",
    "--method importance --importance average --importance-opacity 0.4 "
    "--importance-sparseness screen-door",
    "--method importance --importance-levels muscle=1,spleen=2",
    "--method importance --importance average --importance-opacity 0.3 --importance-levels muscle=1",
    "--method clearview --lens-radius 35 --lens-bends 0.5 --lens-rim 20",
    "--method clearview --lens-place crosshair --crosshair 40,-20,10",
    "--method context-preserving --fade-reach 4 --fade-sharpness 0.7",
    "--method focal-region --focal-size 25 --focal-fall-off 30",
    "--method focal-region --focal-shape box --focal-size 20 --focal-fall-off 15",
    "--method walls --crosshair 20,-10,30 --window 300 --level 40",
    "--method walls --wall-placement inside --wall-axial off --wall-outlines off --crosshair 60,70,-60",
    "--method explode --explosion 0.6 --explosion-planes three",
    "--method explode --explosion 0.3 --explosion-planes one --explosion-axes view",
    "--method selection --ghost-strength 0.8 --ghost-edge 20 --ghost-outline 0.25",
    "--method peel --peel 0.7 --peel-depth 0.3 --peel-radius 20 --peel-margin 12",
    "--method peel --peel-side left --peel-turn 30",
    "--method mip --mip-thickness 4",
    "--method clearview --lens-radius 50 --lens-fade depth"};

TEST_F(MethodCommand, Exhaustive_PicturesAreTheReferences) {
  ASSERT_EQ(render("adaptive.png", ""), 0);
  for (const std::string& method : methods) {
    SCOPED_TRACE(method);
    ASSERT_EQ(render("here.png", method), 0);
    ASSERT_EQ(render("truth.png", method + " --reference"), 0);
    // A bound of 1/255 and two 8-bit roundings, except where the opening's rim grazes a surface.
    EXPECT_LT(shareBeyond(2.0, "here.png", "truth.png"), 0.01);
    EXPECT_GT(shareBeyond(2.0, "adaptive.png", "truth.png"), 0.02) << "the test would notice";
  }
}

TEST_F(MethodCommand, ParametersOfOtherMethodsLeaveThePictureAsItIs) {
  ASSERT_EQ(render("plain.png", ""), 0);
  ASSERT_EQ(render("same.png",
                   "--method adaptive --cone-angle 70 --importance average --importance-opacity 0.9 "
                   "--lens-place crosshair --lens-radius 60 --lens-fade depth --lens-bends 3 --lens-rim 5 --fade-reach "
                   "9 --fade-sharpness 2 "
                   "--focal-shape box --focal-size 9 --focal-fall-off 3 --wall-placement inside --wall-coronal off "
                   "--crosshair 1,2,3 --window 10 --level 5 --explosion 0.9 --explosion-planes three "
                   "--explosion-axes view --ghost-strength 0.3 --ghost-edge 40 --ghost-outline 0.9 "
                   "--peel 0.3 --peel-side left --peel-turn 20 --peel-depth 0.9 --peel-radius 50 --peel-margin 40 "
                   "--mip-thickness 77"),
            0);
  EXPECT_EQ(bytes("plain.png"), bytes("same.png"));
}

TEST_F(MethodCommand, LevelsOfImportanceCountForThatMethodAndAreOnesOfASession) {
  ASSERT_EQ(render("adaptive.png", ""), 0);
  ASSERT_EQ(render("same.png", "--importance-levels muscle=1"), 0);
  EXPECT_EQ(bytes("adaptive.png"), bytes("same.png"));
  ASSERT_EQ(render("one.png", "--method importance"), 0);
  ASSERT_EQ(render("same.png", "--method importance --importance-levels 'left kidney=2',muscle=0"), 0);
  EXPECT_EQ(bytes("one.png"), bytes("same.png")) << "the focus is the one level";
  ASSERT_EQ(
      render("two.png", "--method importance --importance-levels muscle=1 --save-session " + quoted("work.fenestra")),
      0);
  EXPECT_GT(shareBeyond(2.0, "one.png", "two.png"), 0.02);
  const LabelSettings kept = io::readSession(at("work.fenestra")).look.labels;
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept.front().importance, 1);
  ASSERT_EQ(run("render " + quoted("work.fenestra") + " --importance-levels muscle=0 -o " + quoted("same.png")), 0);
  EXPECT_EQ(bytes("one.png"), bytes("same.png"));
}

TEST_F(MethodCommand, LevelsOfImportanceNeedLabelsInFocusAndNumbersUpToFour) {
  for (const char* wrong : {"muscle=5", "muscle=-1", "muscle=1.5", "muscle", "=1", "muscle=", "muscle=1,"}) {
    EXPECT_EQ(render("none.png", std::string("--method importance --importance-levels ") + wrong), 2) << wrong;
    EXPECT_NE(bytes("error").find("--importance-levels"), std::string::npos) << bytes("error");
  }
  EXPECT_EQ(render("none.png", "--method importance --importance-levels muscles=1"), 1);
  EXPECT_NE(bytes("error").find("there is no label \"muscles\""), std::string::npos) << bytes("error");
  EXPECT_EQ(run("render --phantom torso --phantom-voxels 48 --focus-range 150:3000 --method importance "
                "--importance-levels muscle=1 -o " +
                quoted("none.png")),
            1);
  EXPECT_NE(bytes("error").find("no labels in focus"), std::string::npos) << bytes("error");
  EXPECT_FALSE(std::filesystem::exists(at("none.png")));
}

TEST_F(MethodCommand, WhatIsNeitherExplodedNorPeeledIsThePlainPicture) {
  ASSERT_EQ(render("plain.png", "--cutaway off"), 0);
  ASSERT_EQ(render("together.png", "--method explode --explosion 0"), 0);
  EXPECT_EQ(bytes("plain.png"), bytes("together.png"));
  ASSERT_EQ(render("in-place.png", "--method peel --peel 0"), 0);
  EXPECT_EQ(bytes("plain.png"), bytes("in-place.png"));
}

TEST_F(MethodCommand, Exhaustive_ASessionKeepsEach) {
  for (const std::string& method : methods) {
    SCOPED_TRACE(method);
    ASSERT_EQ(render("a.png", method + " --save-session " + quoted("work.fenestra")), 0);
    ASSERT_EQ(run("render " + quoted("work.fenestra") + " -o " + quoted("b.png")), 0);
    EXPECT_EQ(bytes("a.png"), bytes("b.png"));
  }
  const Method kept = io::readSession(at("work.fenestra")).look.method;
  EXPECT_EQ(kept, (methods::ClearView{.fade = LensFade::Depth, .radius = 50.0}));
}

TEST_F(MethodCommand, WallsShowTheSlicesOfASession) {
  ASSERT_EQ(render("a.png", "--method walls --crosshair 20,-10,30 --window 300 --level 40 --save-session " +
                                quoted("work.fenestra")),
            0);
  const io::Session session = io::readSession(at("work.fenestra"));
  EXPECT_EQ(session.crosshair, glm::dvec3(20.0, -10.0, 30.0));
  EXPECT_EQ(session.window, (WindowLevel{300.0, 40.0}));
  const std::string from = "render " + quoted("work.fenestra");
  ASSERT_EQ(run(from + " -o " + quoted("b.png")), 0);
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
  // An option overrides the session's.
  for (const std::string other : {" --crosshair 0,-10,30", " --window 900", " --level 100"}) {
    ASSERT_EQ(run(from + other + " -o " + quoted("b.png")), 0);
    EXPECT_GT(shareBeyond(2.0, "a.png", "b.png"), 0.005) << other;
  }
}

TEST_F(MethodCommand, RefusesWhatIsNoAngleAndNoShare) {
  for (const std::string wrong : {"--cone-angle 0",
                                  "--cone-angle 90",
                                  "--cone-angle nan",
                                  "--importance-angle 0",
                                  "--importance-opacity 1.1",
                                  "--importance some",
                                  "--lens-radius 0",
                                  "--lens-bends -1",
                                  "--lens-rim 0.5",
                                  "--lens-fade away",
                                  "--fade-reach -1",
                                  "--fade-sharpness 0",
                                  "--focal-size 0",
                                  "--focal-fall-off 0",
                                  "--focal-shape ball",
                                  "--wall-placement beside",
                                  "--wall-axial maybe",
                                  "--crosshair 1,2",
                                  "--crosshair 1,2,nan",
                                  "--crosshair 1,2,1e300",
                                  "--window 0",
                                  "--window -5",
                                  "--level wide",
                                  "--explosion -0.1",
                                  "--explosion 1.1",
                                  "--explosion-planes 4",
                                  "--explosion-axes up",
                                  "--ghost-strength 1.1",
                                  "--ghost-edge 0",
                                  "--ghost-outline -0.1",
                                  "--peel 1.1",
                                  "--peel-side front",
                                  "--peel-turn 181",
                                  "--peel-depth -0.1",
                                  "--peel-radius 0",
                                  "--peel-margin -1"})
    EXPECT_EQ(render("x.png", wrong), 2) << wrong;
  EXPECT_FALSE(std::filesystem::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests::methodCommandTest
