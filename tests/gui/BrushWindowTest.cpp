// The brush as a user uses it: a stroke painted in one view shows in both, can be undone, listed and saved.

#include <cmath>
#include <numbers>

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/BrushPanel.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/panels/StrokeList.h"

namespace fenestra::viewer::brushWindowTest {
namespace {

/// The marked ball, opened around the marker, with the brush deep enough to close the opening.
class BrushWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    document().focusOn(marker);
    document().history().clear();
    BrushSettings settings = brush().settings();
    settings.depth = 40.0;
    settings.toSurface = settings.coversFocus = false;
    settings.radius = 10.0;
    brush().setSettings(settings);
    waitUntilDrawn();
    opened_ = look();
  }

  QUndoStack& steps() { return document().undoStack(); }
  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(window_.get(), which, modifiers); }

  /// A place beside the marker where both cameras see that the front of the ball was cut away.
  QPoint besideMarker(std::size_t view) {
    const glm::dvec3 surface = glm::normalize(glm::dvec3(29.0, -29.0, 17.0)) * 44.0;
    return volume(view)->widgetFromWorld(surface)->toPoint();
  }

  QPoint aboveMarker(std::size_t view) {
    const glm::dvec3 surface = glm::normalize(glm::dvec3(26.0, -17.0, 31.0)) * 44.0;
    return volume(view)->widgetFromWorld(surface)->toPoint();
  }

  /// Paints one stroke of some pixels, with the brush active only for that.
  void paint(std::size_t view, QPoint from, QPoint by = {3, 12}) {
    brush().setActive(true);
    drag(volume(view), from, from + by);
    brush().setActive(false);
    waitUntilDrawn();
  }

  /// What both 3-D views show.
  std::array<QImage, 2> look() { return {picture(volume(0)), picture(volume(1))}; }

  std::array<QImage, 2> opened_;
};

TEST_F(BrushWindow, PaintsInC1SeesItInC2AndFindsItAgainAfterTurning) {
  paint(0, besideMarker(0));
  ASSERT_EQ(document().strokes().size(), 1u);
  const BrushStroke& stroke = document().strokes().front();
  EXPECT_GT(stroke.anchors.size(), 1u);
  // The anchors lie on the ball, whose surface is within a voxel of its radius.
  for (const glm::dvec3& anchor : stroke.anchors) EXPECT_NEAR(glm::length(anchor), 44.0, 2.0);
  const std::array<QImage, 2> painted = look();
  EXPECT_NE(painted[0], opened_[0]);
  EXPECT_NE(painted[1], opened_[1]);
  EXPECT_TRUE(green(volume(0))) << "the focus is not covered";

  drag(volume(0), {200, 150}, {280, 190});
  waitUntilDrawn();
  EXPECT_NE(look()[0], painted[0]);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().strokes().empty()) << "turning a view is no step, so the stroke was undone";
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  key(Qt::Key_R);
  waitUntilDrawn();
  EXPECT_EQ(look(), painted);
}

TEST_F(BrushWindow, UndoAndRedoBringBackTheBits) {
  paint(0, besideMarker(0));
  const std::array<QImage, 2> first = look();
  paint(1, aboveMarker(1), {-10, 2});
  const std::array<QImage, 2> second = look();
  ASSERT_EQ(steps().count(), 2) << "a stroke is a step";
  EXPECT_NE(second[1], first[1]);
  EXPECT_TRUE(steps().undoText().contains(QStringLiteral("restore"))) << steps().undoText().toStdString();
  const auto expect = [&](const std::array<QImage, 2>& wanted, const char* when) {
    waitUntilDrawn();
    EXPECT_EQ(look(), wanted) << when;
  };
  key(Qt::Key_Z, Qt::ControlModifier);
  expect(first, "the second undone");
  key(Qt::Key_Z, Qt::ControlModifier);
  expect(opened_, "both undone");
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  expect(first, "the first done again");
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  expect(second, "both done again");
}

TEST_F(BrushWindow, PaintingIsDrawnAtFullQualityAtOnce) {
  brush().setActive(true);
  waitUntilDrawn();  // else the frame of that is counted
  QTest::mousePress(volume(0), Qt::LeftButton, {}, besideMarker(0));
  ASSERT_FALSE(document().strokes().empty());
  EXPECT_FALSE(volume(0)->isSettled());
  QSignalSpy settled(volume(0), &VolumeView::settled);
  const long frames = views().pacer().frames();
  ASSERT_TRUE(settled.wait(patience));
  EXPECT_TRUE(volume(0)->isSettled());
  EXPECT_EQ(views().pacer().frames(), frames) << "no smaller picture comes first";
  QTest::mouseRelease(volume(0), Qt::LeftButton, {}, besideMarker(0));
  brush().setActive(false);
  waitUntilDrawn();
}

TEST_F(BrushWindow, AStrokeWithoutEffectIsNoStep) {
  const QPoint background(6, volume(0)->height() / 2);
  const std::optional<QPointF> skin = volume(0)->widgetFromWorld({-20.0, -38.0, -10.0});  // far from the opening
  paint(0, background, {4, 4});
  EXPECT_EQ(steps().count(), 0);
  paint(0, skin->toPoint());
  EXPECT_EQ(steps().count(), 0) << "there was nothing to restore";
  EXPECT_TRUE(document().strokes().empty());
  EXPECT_EQ(look(), opened_);
  brush().toggle(true);
  paint(0, skin->toPoint());
  EXPECT_EQ(steps().count(), 1) << "but there is something to open";
}

TEST_F(BrushWindow, AStrokeForOneViewShowsInThatAlone) {
  BrushSettings settings = brush().settings();
  settings.thisViewOnly = true;
  brush().setSettings(settings);
  paint(1, besideMarker(1), {-6, 10});
  ASSERT_EQ(document().strokes().size(), 1u);
  EXPECT_EQ(document().strokes().front().view, 1);
  EXPECT_EQ(look()[0], opened_[0]);
  EXPECT_NE(look()[1], opened_[1]);
}

TEST_F(BrushWindow, StrokesAreHiddenDeletedAndCleared) {
  paint(0, besideMarker(0));
  const std::array<QImage, 2> painted = look();
  StrokeList& strokes = panel<StrokeList>();
  QAbstractItemModel& rows = *strokes.list()->model();
  ASSERT_EQ(rows.rowCount(), 1);
  rows.setData(rows.index(0, 0), Qt::Unchecked, Qt::CheckStateRole);
  waitUntilDrawn();
  EXPECT_EQ(look(), opened_);
  rows.setData(rows.index(0, 0), Qt::Checked, Qt::CheckStateRole);
  waitUntilDrawn();
  EXPECT_EQ(look(), painted);

  paint(0, aboveMarker(0), {-8, -2});
  ASSERT_EQ(rows.rowCount(), 2);
  strokes.list()->selectionModel()->select(rows.index(0, 0), QItemSelectionModel::ClearAndSelect);
  strokes.deleteButton()->click();
  EXPECT_EQ(document().strokes().size(), 1u);
  strokes.clearButton()->click();
  EXPECT_TRUE(document().strokes().empty());
  EXPECT_EQ(rows.rowCount(), 0);
  steps().undo();
  steps().undo();
  EXPECT_EQ(rows.rowCount(), 2);
  waitUntilDrawn();
}

TEST_F(BrushWindow, StrokesAreSavedApartAndLoaded) {
  paint(0, besideMarker(0));
  const BrushStrokes painted = document().strokes();
  const std::array<QImage, 2> look0 = look();
  const QString file = toQString(tests::scratchFolder() / "ear.json");
  panel<StrokeList>().save(file);
  open(markedBall());
  document().focusOn(marker);
  panel<StrokeList>().load(file);
  EXPECT_EQ(document().strokes(), painted);
  waitUntilDrawn();
  EXPECT_EQ(look(), look0);
  panel<StrokeList>().load(QStringLiteral("/no/such.json"));
  ASSERT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("such.json")));
}

TEST_F(BrushWindow, KeysAndWheelSetTheBrush) {
  key(Qt::Key_P);
  EXPECT_TRUE(brush().isActive());
  EXPECT_EQ(brush().settings().mode, BrushMode::Restore);
  key(Qt::Key_E);
  EXPECT_TRUE(brush().isActive());
  EXPECT_EQ(brush().settings().mode, BrushMode::Open);
  key(Qt::Key_E);
  EXPECT_FALSE(brush().isActive()) << "the same key deactivates it";
  key(Qt::Key_P);
  EXPECT_EQ(brush().settings().mode, BrushMode::Restore);
  panel<BrushPanel>().modeButton(BrushMode::Strengthen)->click();
  key(Qt::Key_P);
  EXPECT_EQ(brush().settings().mode, BrushMode::Fade) << "the opposite direction of the same kind";

  const double radius = brush().settings().radius;
  key(Qt::Key_BracketRight);
  EXPECT_GT(brush().settings().radius, radius);
  key(Qt::Key_BracketLeft);
  EXPECT_NEAR(brush().settings().radius, radius, 1e-9);

  panel<BrushPanel>().modeButton(BrushMode::Restore)->click();
  const double depth = brush().settings().depth;
  const Camera camera = cameras().camera(0);
  wheel(volume(0), 2, Qt::ShiftModifier);
  EXPECT_GT(brush().settings().depth, 1.1 * depth);
  EXPECT_EQ(panel<BrushPanel>().depth()->value(), std::round(10.0 * brush().settings().depth) / 10.0);
  drag(volume(0), {200, 150}, {200, 250}, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_LT(brush().settings().depth, depth);
  EXPECT_TRUE(document().strokes().empty());
  EXPECT_EQ(cameras().camera(0), camera) << "neither turns nor zooms the view";
  drag(volume(0), {200, 150}, {260, 150}, Qt::LeftButton, Qt::ControlModifier);
  EXPECT_NE(cameras().camera(0), camera) << "with Ctrl the view can be turned";
  wheel(volume(0), 1, Qt::ControlModifier);
  EXPECT_TRUE(document().strokes().empty());
  key(Qt::Key_Escape);
  EXPECT_FALSE(brush().isActive());
  waitUntilDrawn();
}

TEST_F(BrushWindow, RingIsAroundTheMouseAndAsWideAsTheStroke) {
  BrushSettings settings = brush().settings();
  settings.radius = 40.0;
  brush().setSettings(settings);
  const std::optional<QPointF> skin = volume(0)->widgetFromWorld({-15.0, -38.0, -5.0});
  const QPoint at = skin->toPoint();
  brush().setActive(true);
  QMouseEvent move(QEvent::MouseMove, at, volume(0)->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(volume(0), &move);
  waitUntilDrawn();
  const QImage seen = picture(volume(0));
  const double ratio = seen.devicePixelRatio();
  const QPointF margin =
      0.5 * QPointF(volume(0)->width() - seen.width() / ratio, volume(0)->height() - seen.height() / ratio);
  // The ring is 1.5 device-independent pixels wide; antialiased, its middle is full of its colour.
  const auto isRing = [&](double radius, double angle) {
    const QPointF place = (QPointF(at) - margin + radius * QPointF(std::cos(angle), std::sin(angle))) * ratio;
    // The pixel that holds the place; rounding would take one whose middle is up to a pixel off.
    const QColor colour =
        seen.pixelColor(static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y())));
    const auto [least, most] = std::minmax({colour.red(), colour.green(), colour.blue()});
    return most - least < 30 && least > 120;  // grey: there is nothing to restore
  };
  int on = 0, inside = 0, outside = 0;
  constexpr int places = 40;
  for (int place = 0; place < places; ++place) {
    const double angle = 2.0 * std::numbers::pi * (place + 0.5) / places;
    on += isRing(settings.radius, angle) ? 1 : 0;
    inside += isRing(settings.radius - 4.0, angle) ? 1 : 0;
    outside += isRing(settings.radius + 4.0, angle) ? 1 : 0;
  }
  EXPECT_GT(on, places * 8 / 10);
  EXPECT_EQ(inside, 0);
  EXPECT_LT(outside, places / 4) << "but for the text below";

  QTest::mouseClick(volume(0), Qt::LeftButton, {}, at);
  brush().toggle(true);
  QTest::mouseClick(volume(0), Qt::LeftButton, {}, at);
  ASSERT_EQ(document().strokes().size(), 1u) << "nothing to restore, something to open";
  const BrushStroke& stroke = document().strokes().front();
  const glm::dvec3 rim = stroke.anchors.front() + stroke.radius * cameras().camera(0).axes().right;
  const double wide = volume(0)->widgetFromWorld(rim)->x() - volume(0)->widgetFromWorld(stroke.anchors.front())->x();
  // The position of a pixel is known to half a pixel.
  EXPECT_NEAR(wide, settings.radius, 0.5);
  waitUntilDrawn();
}

/// The brush as it is when a user first presses its key.
class FreshBrush : public BrushWindow {
 protected:
  void SetUp() override {
    BrushWindow::SetUp();
    BrushSettings settings;
    settings.radius = 10.0;
    brush().setSettings(settings);
    brush().setActive(true);
  }

  void pointAt(QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, volume(0)->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(volume(0), &move);
  }
  std::optional<BrushObstacle> obstacleAt(QPoint at) {
    waitUntilDrawn();
    pointAt(at);
    return volume(0)->brushTool().obstacle();
  }
  void space() { QTest::keyClick(volume(0), Qt::Key_Space); }
  QPoint onMarker() { return volume(0)->widgetFromWorld(markerCentre)->toPoint(); }
  QPoint onSkin() { return volume(0)->widgetFromWorld({-20.0, -38.0, -10.0})->toPoint(); }
  void edit(const std::function<void(Look&)>& change) {
    Look look = document().look();
    change(look);
    document().edit({}, look);
  }
};

TEST_F(FreshBrush, OneDragBringsBackWhatLiesOverTheFocus) {
  ASSERT_TRUE(green(volume(0)));
  EXPECT_EQ(obstacleAt(onMarker()), std::nullopt);
  BrushSettings settings = brush().settings();
  settings.radius = 60.0;
  brush().setSettings(settings);
  paint(0, onMarker());
  ASSERT_EQ(document().strokes().size(), 1u);
  EXPECT_FALSE(green(volume(0))) << "the context in front of the focus is back, all of it";
}

TEST_F(FreshBrush, SaysWhereRestoringChangesNothing) {
  EXPECT_EQ(obstacleAt({6, volume(0)->height() / 2}), BrushObstacle::NothingThere);
  EXPECT_EQ(obstacleAt(onSkin()), BrushObstacle::NothingRemoved);
  const std::array<QImage, 2> before = look();
  QTest::mouseClick(volume(0), Qt::LeftButton, {}, onSkin());
  EXPECT_EQ(steps().count(), 0) << "and it changes nothing";
  pointAt(onSkin());
  space();
  EXPECT_EQ(brush().settings().mode, BrushMode::Open);
  EXPECT_EQ(obstacleAt(onSkin()), std::nullopt);
  paint(0, onSkin());
  EXPECT_EQ(steps().count(), 1) << "the offered mode does something there";
}

TEST_F(FreshBrush, SaysThatTheFocusIsSpared) {
  BrushSettings settings = brush().settings();
  settings.coversFocus = false;
  settings.radius = 4.0;  // within the marker
  brush().setSettings(settings);
  EXPECT_EQ(obstacleAt(onMarker()), BrushObstacle::SparesFocus);
  space();
  EXPECT_TRUE(brush().settings().coversFocus);
  EXPECT_EQ(obstacleAt(onMarker()), std::nullopt);
}

TEST_F(FreshBrush, SaysThatTheFocusIsOpenAlready) {
  BrushSettings settings = brush().settings();
  settings.mode = BrushMode::Open;
  settings.radius = 4.0;
  brush().setSettings(settings);
  EXPECT_EQ(obstacleAt(onMarker()), BrushObstacle::ReachedFocus);
  space();
  EXPECT_EQ(brush().settings().mode, BrushMode::Restore);
}

TEST_F(FreshBrush, SaysWhyEdgesDoNotChange) {
  BrushSettings settings = brush().settings();
  settings.mode = BrushMode::Fade;
  brush().setSettings(settings);
  EXPECT_EQ(obstacleAt(onMarker()), std::nullopt);
  EXPECT_EQ(obstacleAt(onSkin()), BrushObstacle::OffFocus);
  edit([](Look& look) { look.contextLayer.strength = 0.0; });
  EXPECT_EQ(obstacleAt(onMarker()), BrushObstacle::EdgesOff);
  space();
  EXPECT_GT(document().look().contextLayer.strength, 0.0);
  EXPECT_EQ(obstacleAt(onMarker()), std::nullopt);
}

TEST_F(FreshBrush, Thorough_SaysThatTheMethodCutsNothing) {
  edit([](Look& look) { look.method.kind = kindOf<methods::ContextPreserving>; });
  EXPECT_EQ(obstacleAt(onMarker()), BrushObstacle::NothingIsCut);
  space();
  EXPECT_EQ(document().look().method.kind, kindOf<methods::Adaptive>);
  EXPECT_EQ(obstacleAt(onMarker()), std::nullopt);
}

TEST_F(FreshBrush, SaysThatNothingIsOpen) {
  edit([](Look& look) { look.cutaway.enabled = false; });
  EXPECT_EQ(obstacleAt(onSkin()), BrushObstacle::CutawayOff);
  space();
  EXPECT_TRUE(document().look().cutaway.enabled);
  document().setFocus({});
  EXPECT_EQ(obstacleAt(onSkin()), BrushObstacle::NoFocus);
  space();
  EXPECT_EQ(document().focus(), Focus{}) << "no setting can offer a focus";
}

}  // namespace
}  // namespace fenestra::viewer::brushWindowTest
