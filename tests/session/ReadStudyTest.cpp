// From a request to a study: what is set and what is drawn, and what a session restores.

#include <gtest/gtest.h>

#include "io/LabelWriter.h"
#include "io/VolumeWriter.h"
#include "io/session/SessionFile.h"
#include "io/study/ReadStudy.h"
#include "io/study/SessionData.h"
#include "tests/io/IoTesting.h"
#include "tests/support/Scenes.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::readStudyTest {
namespace {

namespace fs = std::filesystem;

/// A ball of 1000 HU around (20, 20, 20) in air, on a grid of 40³ mm, and a label map of its two halves.
class ReadStudy : public testing::Test {
 protected:
  void SetUp() override {
    const Grid grid = gridOf(glm::ivec3(40));
    const auto isBall = [](glm::ivec3 index) { return glm::length(glm::dvec3(index) - 20.0) < 8.0; };
    io::writeVolume(*volumeOf<std::int16_t>(grid, [&](glm::ivec3 index) { return isBall(index) ? 1000 : -1000; }),
                    folder_ / "ball.nrrd");
    io::writeLabels(*labelsOf(grid, [&](glm::ivec3 index) { return isBall(index) ? (index.x < 20 ? 1 : 2) : 0; }),
                    folder_ / "halves.nrrd");
  }

  io::StudyRequest ball() const {
    io::StudyRequest request;
    request.path = folder_ / "ball.nrrd";
    return request;
  }

  io::StudyRequest saved(io::Session session) const {
    io::noteContents(session);
    io::writeSession(folder_ / "a.fenestra", session);
    return io::requestOfSession(folder_ / "a.fenestra");
  }

  fs::path folder_ = scratchFolder();
};

TEST_F(ReadStudy, DataAloneComeWithTheSessionThatNamesThem) {
  io::DataRequest request = ball();
  request.labels = folder_ / "halves.nrrd";
  const io::Study study = io::openData(request);
  EXPECT_EQ(study.format, "NRRD");
  EXPECT_EQ(study.scene.volume->range.high, 1000.0);
  EXPECT_EQ(study.scene.labels->labels.size(), 2u);
  EXPECT_EQ(study.session.volume.path, fs::absolute(request.path));
  EXPECT_EQ(study.session.labels.path, fs::absolute(request.labels));
  EXPECT_FALSE(study.restoresSession);
  EXPECT_FALSE(study.view) << "nobody looks at it yet";
}

TEST_F(ReadStudy, ARegionIsSetAsSeedsAndDrawnAsLabels) {
  io::StudyRequest request = ball();
  request.region.inside = {glm::dvec3(20.0)};
  const io::Study study = io::readStudy(request);
  EXPECT_TRUE(std::holds_alternative<RegionFocus>(study.scene.look.focus));
  EXPECT_FALSE(study.scene.labels);
  ASSERT_TRUE(study.growth);
  EXPECT_EQ(study.drawn.scene().labels, study.growth->steps);
  EXPECT_TRUE(std::holds_alternative<LabelFocus>(study.drawn.scene().look.focus));
  EXPECT_EQ(study.session.look, study.scene.look) << "a session keeps what is set";
}

TEST_F(ReadStudy, WhatIsCarvedAwayIsDrawnAlone) {
  io::StudyRequest request = ball();
  request.labels = folder_ / "halves.nrrd";
  request.focusLabels = {"1"};
  Removal removal;
  removal.points = {glm::dvec3(20.0)};
  request.look.removals = {removal};
  const io::Study study = io::readStudy(request);
  EXPECT_EQ(study.scene.labels->value({17, 20, 20}), 1);
  ASSERT_TRUE(study.drawn.scene().removed);
  EXPECT_EQ(study.drawn.scene().labels->value({17, 20, 20}), 0);
}

TEST_F(ReadStudy, ASessionComesBackAsItWas) {
  io::StudyRequest request = ball();
  request.labels = folder_ / "halves.nrrd";
  request.focusLabels = {"2"};
  request.camera = io::ViewAngles{30.0, 10.0};
  request.size = glm::ivec2(320, 200);
  const io::Study first = io::readStudy(request);
  const io::Study again = io::readStudy(saved(first.session));
  EXPECT_TRUE(again.restoresSession);
  EXPECT_EQ(again.sessionFile, folder_ / "a.fenestra");
  EXPECT_EQ(again.scene.look, first.scene.look);
  ASSERT_TRUE(again.view);
  EXPECT_EQ(*again.view, *first.view);
  EXPECT_TRUE(again.warnings.empty()) << kindsOf(again.warnings);
}

TEST_F(ReadStudy, NewDataStartInTheStartingLook) {
  const io::Study study = io::readStudy(ball());
  Look look = study.scene.look;
  EXPECT_EQ(look.context.preset, "ct-soft-tissue");
  look.context = {};
  EXPECT_EQ(look, startingLook());
  EXPECT_EQ(look.reconstruction, Reconstruction::Auto);
  EXPECT_EQ(look.labelSmoothing, LabelSmoothing::Light);
  EXPECT_EQ(look.edges, Edges::Smooth);
  EXPECT_EQ(look.shading.occlusion, 0.35);
  EXPECT_EQ(look.shading.shadow, 0.3);
  EXPECT_EQ(look.contextLayer.share, 0.1);
  EXPECT_EQ(look.contextLayer.valueWeight, 1.0);
}

/// The look that all new data had before there was a starting one, without border and edges.
TEST_F(ReadStudy, TheBareLookIsThePlainOneWithoutBorderAndEdges) {
  io::StudyRequest request = ball();
  request.makeBare();
  const Look look = io::readStudy(request).scene.look;
  EXPECT_EQ(look.context.preset, "ct-plain");
  const std::vector<TransferFunction::Node>& nodes = look.context.function.nodes;
  ASSERT_EQ(nodes.size(), 9u);
  EXPECT_EQ(nodes[0].value, -220.0);
  EXPECT_EQ(nodes[4].properties, (OpticalProperties{{0.74, 0.32, 0.27}, extinctionFromOpacity(0.42)}));
  Look rest = look;
  rest.context = {};
  Look plain;
  plain.contextLayer.strength = 0.0;
  plain.cutaway.borderWidth = 0.0;
  EXPECT_EQ(rest, plain);
  EXPECT_EQ(look.reconstruction, Reconstruction::Linear);
  EXPECT_EQ(look.labelSmoothing, LabelSmoothing::Off);
  EXPECT_EQ(look.edges, Edges::Off);
  EXPECT_EQ(look.shading, Shading{});
  EXPECT_EQ(look.shading.occlusion, 0.0);
  EXPECT_EQ(look.shading.shadow, 0.0);
  EXPECT_EQ(Look{}.contextLayer.share, 1.0) << "sessions that do not name it draw every edge";
  EXPECT_EQ(Look{}.contextLayer.colour, glm::dvec3(0.42, 0.70, 0.90));
}

TEST_F(ReadStudy, AScriptsPlainLookIsMadeTheStartingOneAgain) {
  io::StudyRequest request = ball();
  request.makePlain();
  Look plain = io::readStudy(request).scene.look;
  EXPECT_EQ(plain.context.preset, "ct-plain");
  plain.context = {};
  EXPECT_EQ(plain, Look{});
  request.makeStarting();
  EXPECT_EQ(io::readStudy(request).scene.look, io::readStudy(ball()).scene.look);
}

TEST_F(ReadStudy, AnotherLookLeavesASessionsTransferFunction) {
  for (const bool plain : {true, false}) {
    io::StudyRequest request = saved(io::readStudy(ball()).session);
    const ContextFunction own = request.look.context;
    plain ? request.makePlain() : request.makeStarting();
    EXPECT_EQ(io::readStudy(request).scene.look.context, own);
  }
}

TEST_F(ReadStudy, ABareLookLeavesASessionsOwn) {
  io::StudyRequest request = saved(io::readStudy(ball()).session);
  request.makeBare();
  const Look look = io::readStudy(request).scene.look;
  EXPECT_EQ(look.context.preset, "ct-soft-tissue");
  EXPECT_EQ(look.shading, startingLook().shading);
  EXPECT_EQ(look.contextLayer.strength, 0.0);
}

TEST_F(ReadStudy, AutomaticOfAnOlderSessionIsWhatItWasThen) {
  Grid grid = gridOf(glm::ivec3(40));
  grid.spacing = {1.0, 1.0, 5.0};
  io::writeVolume(*volumeOf<std::int16_t>(grid, [](glm::ivec3 index) { return index.z < 20 ? 1000 : -1000; }),
                  folder_ / "ball.nrrd");
  io::Session session = io::readStudy(ball()).session;
  ASSERT_EQ(session.look.reconstruction, Reconstruction::Auto);
  io::StudyRequest request = saved(session);
  EXPECT_EQ(io::readStudy(request).scene.look.reconstruction, Reconstruction::Auto);
  request.session->formerAutomatic = true;
  const io::Study study = io::readStudy(request);
  EXPECT_EQ(study.scene.look.reconstruction, Reconstruction::Smooth);
  EXPECT_FALSE(study.session.formerAutomatic);
}

TEST_F(ReadStudy, EmissionIsReadInInvertedGreys) {
  io::StudyRequest request = ball();
  EXPECT_FALSE(io::readStudy(request).session.inverted);
  request.modality = Modality::PT;
  const io::Study study = io::readStudy(request);
  EXPECT_TRUE(study.session.inverted);
  EXPECT_EQ(study.scene.look.context.preset, "pet");
}

TEST_F(ReadStudy, ARecoveredSessionTakesThePlaceOfTheOneThatItCopies) {
  io::Session session = io::readStudy(ball()).session;
  session.autosaveOf = folder_ / "mine.fenestra";
  io::StudyRequest request = saved(session);
  request.isRecovered = true;
  const io::Study study = io::readStudy(request);
  EXPECT_TRUE(study.isRecovered);
  EXPECT_EQ(study.sessionFile, folder_ / "mine.fenestra");
  EXPECT_TRUE(study.session.autosaveOf.empty());
}

TEST_F(ReadStudy, ASessionsRegionMayComeOutEmptyForAUserToChange) {
  io::Session session = io::readStudy(ball()).session;
  session.look.focus = RegionFocus{{glm::dvec3(20.0), glm::dvec3(500.0)}, {}, 10.0};
  io::StudyRequest request = saved(session);
  EXPECT_NE(errorOf([&] { io::readStudy(request); }).find("does not reach to the seed 500,500,500"), std::string::npos);
  request.acceptsAnyRegion = true;
  EXPECT_TRUE(io::readStudy(request).growth);

  session.look.focus = RegionFocus{{glm::dvec3(500.0)}, {}, 10.0};
  const io::Study without = io::readStudy(saved(session));
  EXPECT_TRUE(hasWarning(without.warnings, io::Warning::Kind::ChangedData));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(without.scene.look.focus));
}

TEST_F(ReadStudy, WhatARegionGrewFromIsKeptForAUserToChangeIt) {
  io::Session session = io::readStudy(ball()).session;
  RegionFocus region{{glm::dvec3(20.0)}, {}, {}};
  region.rule = RegionRule::Tissues;
  session.look.focus = region;
  io::StudyRequest request = saved(session);
  EXPECT_EQ(io::readStudy(request).memory.bytes(), 0u);
  request.acceptsAnyRegion = true;
  EXPECT_TRUE(io::readStudy(request).memory.first());
}

TEST_F(ReadStudy, ProgressRunsForwardAndCancels) {
  io::StudyRequest request = ball();
  request.labels = folder_ / "halves.nrrd";
  double last = 0.0;
  const auto ascending = [&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  };
  io::readStudy(request, ascending);
  EXPECT_GT(last, 0.5);
  EXPECT_THROW(io::readStudy(request, [](double, std::string_view) { return false; }), io::Cancelled);
}

}  // namespace
}  // namespace fenestra::tests::readStudyTest
