// Cameras placed for the focus, in the window.

#include <cmath>

#include <QDockWidget>
#include <QSignalSpy>
#include <QTest>

#include "rendering/gpu/GpuScene.h"
#include "rendering/placement/Placer.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/panels/SphereMap.h"

namespace fenestra::viewer::placedWindowTest {
namespace {

/// The marked ball with the marker in focus and both cameras placed for it.
class PlacedWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    setAutomatic(true);
    bringUp("camerasDock");
    cursor().moveTo(markerCentre);
    SliceView* axial = slice(SlicePlane::Axial);
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->widgetFromWorld(markerCentre).toPoint());
    ASSERT_TRUE(placement().isBusy());
    waitUntilDrawn();
    ASSERT_NE(placement().measured(), nullptr);
  }

  glm::dvec3 direction(int view) { return directionOf(cameras().camera(view)); }
  glm::dvec3 candidate(std::size_t index) { return placement().measured()->candidates.at(index).direction; }

  PlacementForm& form() { return panel<CamerasPanel>().form(); }

  static constexpr double same = 1e-9;  ///< error of unit vectors after a few operations in double precision
};

TEST_F(PlacedWindow, ChoosingALabelMovesBothViewsToTheAnswer) {
  const auto answer =
      placement::choose(*placement().measured(), placement().settings().options, placement().settings().joint);
  ASSERT_TRUE(answer.c1 && answer.c2);
  EXPECT_LT(glm::distance(direction(0), candidate(*answer.c1)), same);
  EXPECT_LT(glm::distance(direction(1), candidate(*answer.c2)), same);
  for (const std::size_t view : {0u, 1u}) EXPECT_TRUE(green(volume(view))) << "view " << view;
  // A convex focus shows less than half of itself to one camera and no more than three quarters to two at right angles.
  ASSERT_TRUE(placement().share());
  EXPECT_NEAR(*placement().share(), answer.share, same);
  EXPECT_GT(answer.share, 0.5);
  const QString percent = QString::number(100.0 * answer.share, 'f', 0);
  EXPECT_TRUE(panel<CamerasPanel>().share()->text().contains(percent));
  // One after the other, the best view comes first.
  form().joint()->click();
  waitUntilDrawn();
  EXPECT_GT(glm::dot(direction(0), glm::normalize(markerCentre)), 0.0) << "from the side where the marker lies";
}

TEST_F(PlacedWindow, MeasuringInSlicesChangesNothing) {
  ASSERT_TRUE(volume(0)->inGlContext([&](const std::shared_ptr<GpuScene>& gpu) {
    const PlacementSettings& settings = placement().settings();
    placement::Placer placer;
    const placement::Measured& whole = placer.measure(*gpu, document().scene(), settings.sampling, settings.options);
    const placement::Measured& sliced = *placement().measured();
    ASSERT_EQ(sliced.candidates.size(), whole.candidates.size());
    EXPECT_EQ(sliced.spread, 192u);
    EXPECT_EQ(sliced.spread, whole.spread);
    EXPECT_EQ(sliced.surfacePoints, whole.surfacePoints);
    for (std::size_t i = 0; i < whole.candidates.size(); ++i) {
      const placement::Candidate &a = sliced.candidates[i], &b = whole.candidates[i];
      EXPECT_EQ(a.direction, b.direction);
      EXPECT_EQ(a.sums.count, b.sums.count);
      EXPECT_EQ(a.sums.depth, b.sums.depth);
      EXPECT_EQ(a.seen, b.seen);
      EXPECT_EQ(a.descriptors.stability, b.descriptors.stability);
    }
  }));
}

TEST_F(PlacedWindow, Thorough_RefiningShowsProgressAndCanBeCancelled) {
  const glm::dvec3 before = direction(0);
  PlacementSettings settings = placement().settings();
  settings.sampling.refined = true;
  settings.sampling.side = 48;
  QSignalSpy progressed(&placement(), &PlacementController::progressed);
  placement().setSettings(settings);
  // On a slow machine the first slices of the work end before a view is measured.
  ASSERT_TRUE(QTest::qWaitFor([&] { return placement().progress() > 0.0; }, patience));
  EXPECT_GE(progressed.count(), 1);
  EXPECT_TRUE(placement().isMeasuring());
  EXPECT_LT(placement().progress(), 1.0);
  placement().cancel();
  EXPECT_FALSE(placement().isMeasuring());
  EXPECT_EQ(placement().measured()->spread, 192u) << "what was measured before stays";
  EXPECT_LT(glm::distance(direction(0), before), same);

  progressed.clear();
  placement().place();
  waitUntilDrawn();
  ASSERT_NE(placement().measured(), nullptr);
  EXPECT_TRUE(placement().measured()->refinedFor == settings.options);
  EXPECT_LT(placement().measured()->spread, 300u);
  double last = 0.0;
  for (const QList<QVariant>& signal : progressed) {
    EXPECT_GE(signal.front().toDouble(), last);
    last = signal.front().toDouble();
  }
}

TEST_F(PlacedWindow, TheWheelScrollsThePanelAndChangesNoValue) {
  volume(0)->setFocus();
  const PlacementSettings before = placement().settings();
  wheel(form().sampling(), 1);
  wheel(form().weight(0)->slider(), 1);
  EXPECT_EQ(placement().settings(), before);
  form().weight(0)->slider()->setFocus();
  wheel(form().weight(0)->slider(), 1);
  EXPECT_NE(placement().settings(), before);
  waitUntilDrawn();
}

TEST_F(PlacedWindow, DraggingC1MovesC2WithinItsRegion) {
  const glm::dvec3 before = direction(0);
  QSignalSpy measured(&placement(), &PlacementController::measuredFocus);
  drag(volume(0), {150, 150}, {330, 190});
  waitUntilDrawn();
  EXPECT_LT(glm::dot(before, direction(0)), 0.9);
  const auto& options = placement().settings().options;
  EXPECT_TRUE(placement::inRegion(direction(0), direction(1), options));
  const auto dual = placement::chooseDual(*placement().measured(), direction(0), options);
  ASSERT_TRUE(dual.c2);
  EXPECT_LT(glm::distance(direction(1), candidate(*dual.c2)), same);

  QTest::mouseClick(form().follow(), Qt::LeftButton, {}, QPoint(6, form().follow()->height() / 2));
  ASSERT_FALSE(placement().settings().follow);
  const double angle = glm::dot(direction(0), direction(1));
  drag(volume(0), {150, 150}, {250, 120});
  EXPECT_NEAR(glm::dot(direction(0), direction(1)), angle, same) << "the linked pair keeps its relation";
  EXPECT_TRUE(measured.isEmpty());
  waitUntilDrawn();
}

TEST_F(PlacedWindow, WeightsAndRegionMoveTheCamerasWithoutMeasuring) {
  form().joint()->click();
  waitUntilDrawn();
  QSignalSpy measured(&placement(), &PlacementController::measuredFocus);
  const glm::dvec3 before = direction(0);
  // As in the paper, a positive weight prefers a larger depth, and so the far side.
  form().weight(0)->box()->setValue(2.0);
  form().weight(1)->box()->setValue(0.0);
  waitUntilDrawn();
  EXPECT_LT(glm::dot(direction(0), before), 0.0);
  EXPECT_LT(glm::dot(direction(0), glm::normalize(markerCentre)), -0.9);
  QTest::keyClick(form().region(), Qt::Key_Down);
  EXPECT_EQ(placement().settings().options.region, placement::Region::Stream);
  waitUntilDrawn();
  EXPECT_TRUE(placement::inRegion(direction(0), direction(1), placement().settings().options));
  EXPECT_TRUE(measured.isEmpty());
  EXPECT_FALSE(placement().isMeasuring());
}

TEST_F(PlacedWindow, PlacingOnRequestIsAStepAndForANewFocusIsNone) {
  QUndoStack& steps = document().undoStack();
  EXPECT_EQ(steps.count(), 1) << "the focus alone: the cameras followed it";
  drag(volume(1), {150, 150}, {260, 190});
  const ViewLink::Pose turned = cameras().pose();
  EXPECT_EQ(steps.count(), 1) << "turned by hand";
  QTest::keyClick(window_.get(), Qt::Key_F5);
  waitUntilDrawn();
  const ViewLink::Pose placed = cameras().pose();
  EXPECT_NE(placed, turned);
  EXPECT_EQ(steps.count(), 2);
  steps.undo();
  EXPECT_EQ(cameras().pose(), turned);
  steps.redo();
  EXPECT_EQ(cameras().pose(), placed);
  QTest::keyClick(window_.get(), Qt::Key_F5);
  waitUntilDrawn();
  EXPECT_EQ(steps.count(), 2) << "they were there already";
}

TEST_F(PlacedWindow, ThumbnailsAndMapTakeC1There) {
  const std::vector<std::size_t> best = placement().best(BestViews::count);
  ASSERT_EQ(best.size(), BestViews::count);
  for (std::size_t rank = 0; rank < best.size(); ++rank) EXPECT_FALSE(panel<BestViews>().button(rank)->icon().isNull());
  QTest::mouseClick(panel<BestViews>().button(2), Qt::LeftButton);
  waitUntilDrawn();
  EXPECT_LT(glm::distance(direction(0), candidate(best[2])), same);

  const glm::dvec3 wanted = glm::normalize(glm::dvec3(-0.3, -1.0, 0.4));
  SphereMap& map = panel<SphereMap>();
  QTest::mouseClick(&map, Qt::LeftButton, {}, map.widgetFromDirection(wanted).toPoint());
  waitUntilDrawn();
  // The map is some 120 device-independent pixels high: a pixel is about 1.5 degrees.
  EXPECT_GT(glm::dot(direction(0), wanted), std::cos(glm::radians(3.0)));
  EXPECT_TRUE(placement::inRegion(direction(0), direction(1), placement().settings().options));
}

TEST_F(PlacedWindow, AClickOnASlicePlacesTheCamerasForItsPoint) {
  const auto choose = [&](int index) {
    form().subject()->setCurrentIndex(index);
    Q_EMIT form().subject()->activated(index);
  };
  choose(1);
  EXPECT_TRUE(placement().settings().byPick);
  const ViewLink::Pose before = cameras().pose();
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint place = axial->widgetFromWorld(markerCentre).toPoint();
  QTest::mouseClick(axial, Qt::LeftButton, {}, place);
  ASSERT_TRUE(placement().isBusy());
  waitUntilDrawn();
  const glm::dvec3 clicked = axial->worldFromWidget(QPointF(place));
  EXPECT_TRUE(placement().note().isEmpty()) << placement().note().toStdString();
  for (const int view : {0, 1}) {
    EXPECT_LT(glm::distance(cameras().camera(view).target, clicked), 1e-6) << view;
    EXPECT_GT(glm::distance(cameras().camera(view).target, before.cameras[0].target), 1.0) << view;
  }
  document().undoStack().undo();
  EXPECT_EQ(cameras().pose().cameras, before.cameras);
  document().setFocus({});
  const QString asksForAClick = panel<CamerasPanel>().share()->text();
  choose(0);
  EXPECT_FALSE(placement().settings().byPick);
  EXPECT_NE(panel<CamerasPanel>().share()->text(), asksForAClick);
}

}  // namespace
}  // namespace fenestra::viewer::placedWindowTest
