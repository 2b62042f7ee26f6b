// A region in the focus, behind the window: clicks, tolerance, undo, growing in the background, labels kept and edited.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "viewer/jobs/LabelEditor.h"
#include "viewer/jobs/RegionGrower.h"
#include "viewer/model/Document.h"
#include "viewer/model/StructureClick.h"

namespace fenestra::viewer {
namespace {

constexpr int patience = 30000;  ///< ms; reached only when something hangs

/// Two balls of value 500 in 100, with noise, 150×60×60 voxels of 1 mm: the second lies beyond previewBox.
const glm::dvec3 left(30.0, 30.0, 30.0), right(115.0, 30.0, 30.0);
constexpr double radius = 16.0;

io::Study twoBalls() {
  auto volume = std::make_shared<Volume>();
  volume->grid.dims = {150, 60, 60};
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 10.0);
  auto values = volume->voxels.as<std::int16_t>();
  for (int z = 0; z < 60; ++z)
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 150; ++x) {
        const glm::dvec3 at(x, y, z);
        const double value = std::min(glm::distance(at, left), glm::distance(at, right)) < radius ? 500.0 : 100.0;
        values[volume->grid.offset({x, y, z})] = static_cast<std::int16_t>(value + noise(random));
      }
  volume->computeRange();
  io::Study made;
  made.scene.volume = volume;
  made.scene.look.context.function.nodes = {{200.0, {glm::dvec3(1.0), 0.0}}, {300.0, {glm::dvec3(1.0), 1.0}}};
  return made;
}

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
  bool showedPart = false;
  QObject::connect(&document_, &Document::focusChanged, &grower_, [&] {
    showedPart = showedPart || (document_.growth() && !document_.isWhole() && shownVolume() > 0.0);
  });
  click(left);
  EXPECT_TRUE(grower_.isGrowing());
  EXPECT_EQ(document_.undoStack().count(), 1);
  waitUntilGrown();
  EXPECT_TRUE(showedPart);
  EXPECT_NEAR(shownVolume(), ball, 0.05 * ball);  // the surface's voxels are about a tenth of the ball; half may err
  EXPECT_FALSE(document_.labels());
  document_.undoStack().undo();
  EXPECT_TRUE(std::holds_alternative<std::monostate>(document_.focus()));
  EXPECT_EQ(shownVolume(), 0.0);
  document_.undoStack().redo();
  EXPECT_TRUE(document_.isWhole()) << "undo comes back to what was grown, at once";
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

TEST_F(Regions, OnlyTheLastOfManyQuickClicksIsGrown) {
  for (int i = 0; i < 10; ++i) click(i % 2 ? left : right);
  click(left + 3.0);
  waitUntilGrown();
  EXPECT_EQ(document_.region()->inside, std::vector<glm::dvec3>{left + 3.0});
  EXPECT_NEAR(shownVolume(), ball, 0.05 * ball);
}

TEST_F(Regions, AClickOnALabelChoosesTheLabel) {
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

TEST_F(Regions, KeptLabelsAreEditedAndUndoneToTheBit) {
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

}  // namespace
}  // namespace fenestra::viewer
