// A region in the focus, behind the window: clicks, tolerance, undo, growing in the background, labels kept and edited.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "io/study/GrowRegion.h"
#include "tests/gui/Patience.h"
#include "viewer/jobs/LabelEditor.h"
#include "viewer/jobs/RegionGrower.h"
#include "viewer/model/Document.h"
#include "viewer/model/RegionText.h"
#include "viewer/model/StructureClick.h"

namespace fenestra::viewer::regionTest {
namespace {

/// Two balls of value 500 in 100, with noise, 150×60×60 voxels of 1 mm: the second lies beyond previewBox().
const glm::dvec3 left(30.0, 30.0, 30.0), right(115.0, 30.0, 30.0);
constexpr double radius = 16.0;

io::Study study(glm::ivec3 dims, const std::vector<glm::dvec3>& balls, double ballRadius) {
  auto volume = std::make_shared<Volume>();
  volume->grid.dims = dims;
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 10.0);
  auto values = volume->voxels.as<std::int16_t>();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const auto holds = [&](glm::dvec3 ball) { return glm::distance(glm::dvec3(x, y, z), ball) < ballRadius; };
        const double value = std::any_of(balls.begin(), balls.end(), holds) ? 500.0 : 100.0;
        values[volume->grid.offset({x, y, z})] = static_cast<std::int16_t>(value + noise(random));
      }
  volume->computeRange();
  io::Study made;
  made.scene.volume = volume;
  made.scene.look.context.function.nodes = {{200.0, {glm::dvec3(1.0), 0.0}}, {300.0, {glm::dvec3(1.0), 1.0}}};
  return made;
}

io::Study twoBalls() { return study({150, 60, 60}, {left, right}, radius); }

/// A ball of 24 mm: a fifth of the volume.
const glm::dvec3 largeCentre(30.0, 30.0, 30.0);
io::Study largeBall() { return study({60, 60, 76}, {largeCentre}, 24.0); }

class Regions : public testing::Test {
 protected:
  void SetUp() override { document_.open(twoBalls()); }

  void waitUntilGrown() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return document_.isWhole(); }, patience));
    ASSERT_FALSE(grower_.isGrowing());
  }
  void click(glm::dvec3 world, Qt::KeyboardModifiers modifiers = {}) {
    clickStructure(document_, world, modifiers, true);
  }
  /// mm³ of the labels in the focus of the scene that is drawn.
  double shownVolume() const {
    const Scene& scene = document_.scene();
    const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
    if (!focus || !scene.labels) return 0.0;
    double voxels = 0.0;
    scene.labels->voxels.visit([&](auto values) {
      for (const auto value : values)
        if (std::binary_search(focus->labels.begin(), focus->labels.end(), static_cast<std::uint16_t>(value))) ++voxels;
    });
    return voxels * scene.volume->grid.voxelVolume();
  }
  std::vector<std::uint16_t> labelValues() const {
    std::vector<std::uint16_t> all;
    if (document_.labels())
      document_.labels()->voxels.visit([&](auto values) { all.assign(values.begin(), values.end()); });
    return all;
  }
  void waitUntilEdited() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !editor_.job().isRunning(); }, patience));
  }

  static constexpr double ball = 4.0 / 3.0 * 3.14159265358979 * radius * radius * radius;
  Document document_;
  RegionGrower grower_{document_};
  LabelEditor editor_{document_};
};

TEST_F(Regions, AClickGrowsTheStructureAndShowsAFirstPartOfIt) {
  QSignalSpy changes(&document_, &Document::focusChanged);
  QSignalSpy scenes(&document_, &Document::sceneChanged);
  bool showedPart = false;
  QObject::connect(&document_, &Document::focusChanged, &grower_, [&] {
    showedPart = showedPart || (document_.growth() && !document_.isWhole() && shownVolume() > 0.0);
  });
  click(left);
  EXPECT_TRUE(grower_.isGrowing());
  EXPECT_EQ(document_.undoStack().count(), 1);
  waitUntilGrown();
  EXPECT_TRUE(showedPart);
  EXPECT_EQ(scenes.count(), 2) << "the part and the whole: pictures are drawn for no other reason";
  EXPECT_NEAR(shownVolume(), ball, 0.05 * ball);  // the surface's voxels are about a tenth of the ball; half may err
  EXPECT_FALSE(document_.labels());
  document_.undoStack().undo();
  EXPECT_TRUE(std::holds_alternative<std::monostate>(document_.focus()));
  EXPECT_EQ(shownVolume(), 0.0);
  document_.undoStack().redo();
  EXPECT_TRUE(document_.isWhole()) << "undo comes back to what was grown, at once";
}

TEST_F(Regions, Thorough_AStructureLargerThanTheFirstPartShowsItsOutlineOnTheSlice) {
  const glm::dvec3 centre(89.5);
  document_.open(study(glm::ivec3(180), {centre}, 80.0));
  int parts = 0;
  QObject::connect(&document_, &Document::focusChanged, &grower_, [&] {
    if (!document_.growth() || document_.isWhole()) return;
    ++parts;
    const segmentation::Growth& part = *document_.growth();
    EXPECT_EQ(part.box.dims().x, 180);
    EXPECT_LT(part.box.dims().z, 50);
    EXPECT_TRUE(part.box.contains(glm::ivec3(centre)));
    const double disc = 3.14159265358979 * 80.0 * 80.0 * part.box.dims().z;
    EXPECT_NEAR(document_.regionVolume(), disc, 0.1 * disc);
    EXPECT_EQ(shownVolume(), 0.0) << "a layer is no structure";
  });
  click(centre);
  waitUntilGrown();
  EXPECT_EQ(parts, 1);
}

TEST_F(Regions, AFirstPartGoesWhereTheWholeRegionAsks) {
  const glm::dvec3 centre(78.5);
  document_.open(study(glm::ivec3(158), {centre}, 54.0));  // a sixth of the volume
  bool showedPart = false;
  QObject::connect(&document_, &Document::focusChanged, &grower_, [&] {
    showedPart = showedPart || (document_.growth() && !document_.isWhole() && shownVolume() > 0.0);
  });
  QSignalSpy scenes(&document_, &Document::sceneChanged);
  click(centre);
  waitUntilGrown();
  EXPECT_TRUE(showedPart);
  ASSERT_TRUE(document_.asksToOpen());
  EXPECT_EQ(shownVolume(), 0.0);
  EXPECT_EQ(scenes.count(), 2) << "the part comes and goes";
  document_.openToRegion();
  EXPECT_GT(shownVolume(), 0.0);
  EXPECT_EQ(scenes.count(), 3);
}

TEST_F(Regions, TheToleranceChangesTheRegionAtOnceAndIsUndone) {
  click(left);
  waitUntilGrown();
  const double before = shownVolume();
  const int step = document_.regionStep();
  document_.setTolerance(10000.0);  // everything
  EXPECT_FALSE(grower_.isGrowing()) << "a tolerance is a threshold";
  EXPECT_GT(shownVolume(), 10.0 * before);
  document_.setTolerance(43.21);
  EXPECT_EQ(document_.region()->tolerance, 43.21) << "the number typed is the number kept";
  document_.undoStack().undo();
  EXPECT_EQ(document_.region()->tolerance, 10000.0);
  document_.undoStack().undo();
  EXPECT_FALSE(document_.region()->tolerance);
  EXPECT_EQ(document_.regionStep(), step);
  EXPECT_EQ(shownVolume(), before);
  document_.history().beginGesture();
  for (int i = 0; i < 5; ++i) document_.moveTolerance(1);
  document_.history().endGesture();
  EXPECT_EQ(document_.regionStep(), step + 5);
  document_.undoStack().undo();
  EXPECT_EQ(document_.regionStep(), step) << "a drag is one step";
}

TEST_F(Regions, ShiftAddsAndCtrlTakesAway) {
  click(left);
  waitUntilGrown();
  const double one = shownVolume();
  click(right, Qt::ShiftModifier);
  EXPECT_EQ(shownVolume(), one) << "what there was shows until the new region is grown";
  waitUntilGrown();
  EXPECT_EQ(document_.region()->inside.size(), 2u);
  EXPECT_GT(shownVolume(), 1.9 * one);
  document_.setTolerance(10000.0);
  const double all = shownVolume();
  click({75.0, 30.0, 30.0}, Qt::ControlModifier);
  waitUntilGrown();
  EXPECT_EQ(document_.region()->outside.size(), 1u);
  EXPECT_LT(shownVolume(), 0.5 * all);
  for (int i = 0; i < 3; ++i) document_.undoStack().undo();
  EXPECT_TRUE(document_.isWhole());
  EXPECT_EQ(shownVolume(), one);
}

TEST_F(Regions, CancellingBringsBackTheFocusBefore) {
  document_.setFocus(ValueFocus{.values = {400.0, 600.0}});
  click(left);
  ASSERT_TRUE(grower_.isGrowing());
  grower_.cancel();
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(document_.focus()));
  EXPECT_FALSE(document_.undoStack().canRedo());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !grower_.job().isRunning(); }, patience));
  // Cancelled from the job's own button, with a step of the user in between.
  click(left);
  document_.setShift(5.0);
  grower_.job().cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !grower_.isGrowing(); }, patience));
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(document_.focus()));
  EXPECT_EQ(document_.shift(), 5.0);
}

TEST_F(Regions, WhatSurroundsTheStructuresIsNoRegion) {
  QSignalSpy failures(&grower_, &RegionGrower::failed);
  click({75.0, 5.0, 5.0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !grower_.isGrowing(); }, patience));
  EXPECT_EQ(failures.count(), 1);
  EXPECT_FALSE(document_.region());
  EXPECT_FALSE(document_.undoStack().canUndo());
}

TEST_F(Regions, TheFocusBeforeStaysWholeUntilTheRegionIs) {
  document_.setFocus(ValueFocus{.values = {400.0, 600.0}});
  const Focus before = document_.scene().look.focus;
  bool hadPart = false;
  const auto watch = QObject::connect(&document_, &Document::focusChanged, &grower_, [&] {
    if (document_.isWhole()) return;
    hadPart = hadPart || document_.growth();
    EXPECT_EQ(document_.scene().look.focus, before);
  });
  click(left);
  EXPECT_EQ(document_.scene().look.focus, before);
  waitUntilGrown();
  QObject::disconnect(watch);
  EXPECT_TRUE(hadPart) << "for the slices' outline";
  EXPECT_NEAR(shownVolume(), ball, 0.05 * ball);
  // From one region to the next, too.
  click(right);
  EXPECT_NEAR(shownVolume(), ball, 0.05 * ball);
  EXPECT_FALSE(document_.showsGrowth());
  grower_.cancel();
  EXPECT_EQ(document_.region()->inside.front(), left);
  EXPECT_TRUE(document_.showsGrowth());
}

TEST_F(Regions, Thorough_ALargeRegionAsksBeforeThePicturesOpenToIt) {
  document_.open(largeBall());
  document_.setFocus(ValueFocus{.values = {400.0, 600.0}});
  const Focus before = document_.focus();
  click(largeCentre);
  waitUntilGrown();
  ASSERT_TRUE(document_.asksToOpen());
  EXPECT_GT(document_.regionShareOfBody(), segmentation::largeShareOfBody);
  EXPECT_EQ(document_.scene().look.focus, before);
  document_.openToRegion();
  EXPECT_FALSE(document_.asksToOpen());
  EXPECT_GT(shownVolume(), 40000.0);
  document_.undoStack().undo();
  document_.undoStack().redo();
  EXPECT_TRUE(document_.showsGrowth()) << "it asks once";
  click(largeCentre + 2.0, Qt::ShiftModifier);
  waitUntilGrown();
  EXPECT_TRUE(document_.showsGrowth()) << "a correction that hardly enlarges it is no reason to ask again";

  document_.setFocus(before);
  click(largeCentre + 5.0);
  waitUntilGrown();
  ASSERT_TRUE(document_.asksToOpen()) << "another region";
  document_.setTolerance(0.0);
  EXPECT_FALSE(document_.asksToOpen()) << "smaller";
  document_.setTolerance(std::nullopt);
  EXPECT_TRUE(document_.showsGrowth()) << "the user's own doing";
  document_.setFocus(before);
  click(largeCentre - 5.0);
  waitUntilGrown();
  ASSERT_TRUE(document_.asksToOpen());
  grower_.cancel();
  EXPECT_EQ(document_.focus(), before);
}

TEST_F(Regions, Thorough_TheTissuesAreFoundOnceAndLiveAsLongAsTheRegion) {
  EXPECT_EQ(grower_.memory().bytes(), 0u) << "before a click";
  click(left);
  waitUntilGrown();
  const std::shared_ptr<const segmentation::TissueTree> tissues = grower_.memory().tissues();
  const std::shared_ptr<const segmentation::FirstRegion> first = grower_.memory().first();
  ASSERT_TRUE(tissues);
  ASSERT_TRUE(first);
  EXPECT_EQ(document_.region()->rule, RegionRule::Tissues);
  click(right, Qt::ShiftModifier);
  waitUntilGrown();
  EXPECT_EQ(grower_.memory().first(), first) << "a correction";
  click(right);
  waitUntilGrown();
  EXPECT_EQ(grower_.memory().tissues(), tissues);
  EXPECT_NE(grower_.memory().first(), first) << "another region";
  document_.setFocus(std::monostate{});
  EXPECT_EQ(grower_.memory().bytes(), 0u) << "no region lives";
  document_.undoStack().undo();
  EXPECT_TRUE(document_.isWhole());
  click(left, Qt::ControlModifier);
  waitUntilGrown();
  EXPECT_TRUE(grower_.memory().tissues()) << "found again for a correction";
  document_.open(twoBalls());
  EXPECT_EQ(grower_.memory().bytes(), 0u) << "another study";
}

TEST_F(Regions, AnOpenedRegionIsCorrectedFromWhatItGrewFrom) {
  io::Study opened = twoBalls();
  RegionFocus region{{left}, {}, {}};
  region.rule = RegionRule::Tissues;
  opened.scene.look.focus = region;
  opened.growth = io::growRegion(*opened.scene.volume, region, {}, opened.memory);
  const std::shared_ptr<const segmentation::FirstRegion> first = opened.memory.first();
  ASSERT_TRUE(first);
  document_.open(std::move(opened));
  EXPECT_TRUE(document_.isWhole());
  click(right, Qt::ShiftModifier);
  waitUntilGrown();
  EXPECT_EQ(grower_.memory().first(), first);
}

TEST_F(Regions, Thorough_GrownAgainFromItsSeedsARegionIsTheSame) {
  // Sessions and `fenestra-cli grow` have the seeds alone, and grow from them with nothing known of the volume.
  const auto expectSame = [&](const char* what) {
    const auto again = io::growWholeRegion(*document_.scene().volume, *document_.region(), "made");
    const auto shown = document_.growth()->steps->voxels.as<std::uint8_t>();
    const auto same = again->steps->voxels.as<std::uint8_t>();
    EXPECT_TRUE(std::equal(shown.begin(), shown.end(), same.begin(), same.end())) << what;
    EXPECT_EQ(again->stepOf(*document_.region()), document_.regionStep()) << what;
  };
  click(left);
  waitUntilGrown();
  const double one = shownVolume();
  expectSame("a click");
  click(right, Qt::ShiftModifier);
  waitUntilGrown();
  expectSame("a further seed");
  click({100.0, 30.0, 30.0}, Qt::ControlModifier);
  waitUntilGrown();
  EXPECT_EQ(document_.region()->outside.size(), 1u);
  const double three = shownVolume();
  expectSame("a seed outside");
  document_.setBall(30.0);
  waitUntilGrown();
  expectSame("a ball");
  for (int i = 0; i < 3; ++i) document_.undoStack().undo();
  EXPECT_TRUE(document_.isWhole());
  EXPECT_EQ(shownVolume(), one);
  expectSame("undone");
  for (int i = 0; i < 2; ++i) document_.undoStack().redo();
  EXPECT_EQ(shownVolume(), three);
  expectSame("done again");
}

TEST_F(Regions, Thorough_ABallBoundsTheRegion) {
  document_.growFrom(left, 8.0);
  waitUntilGrown();
  const double bound = ball / 8.0;
  EXPECT_NEAR(shownVolume(), bound, 0.1 * bound);
  document_.setBall(12.0);
  waitUntilGrown();
  EXPECT_NEAR(shownVolume(), bound * 3.375, 0.35 * bound);
  document_.setBall(0.0);
  waitUntilGrown();
  EXPECT_NEAR(shownVolume(), ball, 0.05 * ball);
  document_.undoStack().undo();
  EXPECT_EQ(document_.region()->ball, 12.0);
  EXPECT_TRUE(document_.isWhole());
}

TEST_F(Regions, Thorough_SaysWhatItIs) {
  EXPECT_FALSE(document_.regionFacts());
  click(left);
  waitUntilGrown();
  const std::optional<segmentation::RegionFacts> facts = document_.regionFacts();
  ASSERT_TRUE(facts);
  EXPECT_NEAR(facts->volume, shownVolume(), 1.0);
  EXPECT_NEAR(facts->mean, 500.0, 10.0);
  EXPECT_NEAR(facts->deviation, 10.0, 5.0);
  EXPECT_EQ(facts->border, segmentation::Border::Clear);
  ASSERT_TRUE(facts->leak);
  EXPECT_GT(facts->leak->volume, 5.0 * facts->volume);
  EXPECT_GT(facts->leak->tolerance, 100.0);
  EXPECT_GT(facts->leak->towards.x, 0.9) << "most of the rest lies to the left";
  const QStringList sentences = regionSentences(*facts, "HU");
  ASSERT_EQ(sentences.size(), 3);
  EXPECT_TRUE(sentences[0].contains(QLatin1String(" HU"))) << sentences[0].toStdString();
  EXPECT_TRUE(sentences[1].startsWith(QLatin1String("Its border is clear"))) << sentences[1].toStdString();
  EXPECT_TRUE(sentences[2].endsWith(QLatin1String("towards the left."))) << sentences[2].toStdString();
  // Beyond the leak it is everything, on no plateau of its own, and nothing is left to leak into.
  document_.setTolerance(10000.0);
  EXPECT_FALSE(document_.regionFacts()->leak);
  document_.paintSelection({{right}, 5.0});
  waitUntilGrown();
  EXPECT_TRUE(document_.regionFacts());
}

TEST(RegionText, NamesDirectionsInThePatient) {
  EXPECT_EQ(directionText({0.0, 0.0, 1.0}), "towards the head");
  EXPECT_EQ(directionText({0.0, 0.6, -0.8}), "towards the feet and the back");
  EXPECT_EQ(directionText({-0.9, -0.1, 0.4}), "towards the right");
  EXPECT_EQ(directionText({0.0, -1.0, 0.0}), "towards the front");
  EXPECT_EQ(directionText(glm::dvec3(0.0)), "on all sides");
}

TEST_F(Regions, Thorough_WithoutGrowingAClickLeavesTheFocusAlone) {
  clickStructure(document_, left, {}, false);
  EXPECT_FALSE(document_.region());
  click(left);
  waitUntilGrown();
  editor_.keepRegion(QStringLiteral("left"), glm::dvec3(0.5));
  waitUntilEdited();
  document_.setFocus(std::monostate{});
  clickStructure(document_, left, {}, false);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(document_.focus())) << "labels as regions";
  clickStructure(document_, left, Qt::ControlModifier, false);
  EXPECT_TRUE(document_.isFocused(1));
}

TEST_F(Regions, OnlyTheLastOfManyQuickClicksIsGrown) {
  for (int i = 0; i < 10; ++i) click(i % 2 ? left : right);
  click(left + 3.0);
  waitUntilGrown();
  EXPECT_EQ(document_.region()->inside, std::vector<glm::dvec3>{left + 3.0});
  EXPECT_NEAR(shownVolume(), ball, 0.05 * ball);
}

TEST_F(Regions, Thorough_AClickOnALabelChoosesTheLabel) {
  click(left);
  waitUntilGrown();
  editor_.keepRegion(QStringLiteral("left"), {0.1, 0.9, 0.2});
  waitUntilEdited();
  ASSERT_TRUE(document_.labels());
  EXPECT_EQ(document_.focus(), Focus(LabelFocus{{1}}));
  EXPECT_EQ(document_.labels()->labels, (std::vector<Label>{{1, "left", {0.1, 0.9, 0.2}}}));
  click(right);
  waitUntilGrown();
  EXPECT_TRUE(document_.labels()) << "labels stay while a region is the focus";
  click(left);
  EXPECT_EQ(document_.focus(), Focus(LabelFocus{{1}}));
  EXPECT_FALSE(grower_.isGrowing());
}

TEST_F(Regions, Thorough_KeptLabelsAreEditedAndUndoneToTheBit) {
  click(left);
  waitUntilGrown();
  const double grown = shownVolume();
  editor_.keepRegion(QStringLiteral("left"), glm::dvec3(0.5));
  waitUntilEdited();
  EXPECT_EQ(shownVolume(), grown);
  EXPECT_FALSE(document_.labelsAreInFile());
  const std::vector<std::uint16_t> kept = labelValues();
  editor_.edit(1, LabelOperation::Grow, 3.0);
  waitUntilEdited();
  EXPECT_NEAR(shownVolume(), ball * std::pow((radius + 3.0) / radius, 3.0), 0.1 * ball);
  const std::vector<std::uint16_t> larger = labelValues();
  editor_.edit(1, LabelOperation::Shrink, 6.0);
  waitUntilEdited();
  EXPECT_LT(shownVolume(), grown);
  document_.undoStack().undo();
  EXPECT_EQ(labelValues(), larger);
  document_.undoStack().undo();
  EXPECT_EQ(labelValues(), kept);
  document_.undoStack().undo();
  EXPECT_FALSE(document_.labels());
  EXPECT_TRUE(document_.labelsAreInFile());
  EXPECT_TRUE(document_.isWhole()) << "the region is the focus again";
  EXPECT_EQ(shownVolume(), grown);
  for (int i = 0; i < 3; ++i) document_.undoStack().redo();
  EXPECT_LT(shownVolume(), grown);

  QSignalSpy failures(&editor_.job(), &LoadJob::failed);
  editor_.edit(1, LabelOperation::Shrink, 20.0);
  waitUntilEdited();
  EXPECT_EQ(failures.count(), 1) << "an empty label is an error";
}

TEST_F(Regions, ARegionForWhichNoLabelIsLeftIsAnError) {
  auto full = std::make_shared<LabelMap>();
  full->grid = document_.scene().volume->grid;
  full->voxels = Voxels(ScalarType::UInt16, full->grid.voxelCount());
  for (int value = 1; value <= 65535; ++value)
    full->labels.push_back({static_cast<std::uint16_t>(value), "label", glm::dvec3(1.0)});
  document_.setLabels(full);
  document_.growFrom(left);
  waitUntilGrown();
  QSignalSpy failures(&editor_.job(), &LoadJob::failed);
  editor_.keepRegion(QStringLiteral("one more"), glm::dvec3(1.0));
  waitUntilEdited();
  ASSERT_EQ(failures.count(), 1);
  EXPECT_TRUE(failures.front().front().toString().contains(QStringLiteral("65535"))) << "and the window shows it";
  EXPECT_EQ(document_.labels(), full);
}

}  // namespace
}  // namespace fenestra::viewer::regionTest
