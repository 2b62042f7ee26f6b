// Carving in the window as a user does it: with the mouse in 3-D and on slices, step by step, and back to the bit.

#include <atomic>

#include <QComboBox>
#include <QOpenGLContext>
#include <QScopeGuard>
#include <QTest>
#include <QThread>

#include "rendering/scene/RemovedVoxels.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/panels/CarvingRows.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/views/ScenePreparation.h"

namespace fenestra::viewer::carveWindowTest {
namespace {

class CarveWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (HasFatalFailure() || IsSkipped()) return;
    setAutomatic(false);
    document().focusOn(marker);
    use(kindOf<methods::Sculpt>);
    waitUntilDrawn();
    document().history().clear();
    whole_ = look();
  }
  void use(MethodKind kind) {
    Look look = document().look();
    look.method.kind = kind;
    document().edit(QStringLiteral("method"), std::move(look));
  }
  Carving& carving() { return window_->workspace().carving; }
  CarvingRows& rows() { return panel<CarvingRows>(); }
  void choose(RemovalShape shape) {
    rows().shape()->setCurrentIndex(static_cast<int>(shape));
    Q_EMIT rows().shape()->activated(static_cast<int>(shape));
  }
  void carve(QWidget* view, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
    if (!carving().isActive()) rows().carve()->click();
    ASSERT_TRUE(carving().isActive());
    drag(view, from, to, Qt::LeftButton, modifiers);
    waitUntilDrawn();
  }
  /// Where C1 sees the ball's surface, some mm from the middle along the view's right and up.
  QPoint onBall(double right, double up) {
    const Camera::Axes axes = cameras().camera(0).axes();
    const double deep = std::sqrt(44.0 * 44.0 - right * right - up * up);
    return volume(0)->widgetFromWorld(right * axes.right + up * axes.up - deep * axes.forward)->toPoint();
  }
  /// Both 3-D views without the tool's ring.
  std::array<QImage, 2> look() {
    carving().setActive(false);
    waitUntilDrawn();
    return {picture(volume(0)), picture(volume(1))};
  }
  int steps() { return document().undoStack().index(); }

  std::array<QImage, 2> whole_;
};

TEST_F(CarveWindow, Thorough_EachStrokeIsAStepThatUndoTakesBackToTheBit) {
  EXPECT_TRUE(rows().isVisibleTo(&panel<CutawayPanel>()));
  EXPECT_FALSE(rows().restore()->isEnabled());
  const Camera camera = cameras().camera(0);
  for (const RemovalShape shape : {RemovalShape::Ball, RemovalShape::Box, RemovalShape::Saw}) {
    SCOPED_TRACE(wordOf(shape).word);
    choose(shape);
    carve(volume(0), onBall(-10.0, 5.0), onBall(12.0, 8.0));
    ASSERT_EQ(document().removals().size(), 1u);
    const Removal& removal = document().removals().front();
    EXPECT_EQ(removal.shape, shape);
    EXPECT_GT(removal.points.size(), 1u);
    // Points lie on the surface that was seen, to the voxel.
    EXPECT_NEAR(glm::length(removal.points.front()), 44.0, 2.0);
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(cameras().camera(0), camera) << "the view does not turn";
    EXPECT_NE(look()[0], whole_[0]);
    EXPECT_TRUE(rows().restore()->isEnabled());
    document().undoStack().undo();
    EXPECT_TRUE(document().removals().empty());
    waitUntilDrawn();
    EXPECT_EQ(look(), whole_) << "to the bit";
  }
}

TEST_F(CarveWindow, ShowsInBothViewsWithEveryMethodAndRestoreAllIsAStep) {
  carve(volume(0), onBall(-10.0, 5.0), onBall(12.0, 8.0));
  carve(volume(0), onBall(-5.0, -15.0), onBall(5.0, -15.0));
  ASSERT_EQ(document().removals().size(), 2u);
  use(kindOf<methods::Adaptive>);
  EXPECT_FALSE(carving().isActive()) << "another method has no tool";
  EXPECT_FALSE(rows().isVisibleTo(&panel<CutawayPanel>()));
  waitUntilDrawn();
  const auto carved = look();
  const Removals kept = document().removals();
  document().setRemovals({}, QStringLiteral("none"));
  waitUntilDrawn();
  EXPECT_NE(look()[0], carved[0]);
  document().undoStack().undo();
  use(kindOf<methods::Sculpt>);
  const int before = steps();
  rows().restore()->click();
  EXPECT_TRUE(document().removals().empty());
  EXPECT_EQ(steps(), before + 1);
  waitUntilDrawn();
  EXPECT_EQ(look(), whole_);
  document().undoStack().undo();
  EXPECT_EQ(document().removals(), kept);
}

TEST_F(CarveWindow, CarvesOnSlicesAndLeavesTheWindowAlone) {
  const WindowLevel window = document().window();
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint middle = axial->widgetFromWorld({10.0, 5.0, 0.0}).toPoint();
  const QImage before = picture(axial);
  carve(axial, middle, middle + QPoint(12, 0));
  ASSERT_EQ(document().removals().size(), 1u);
  EXPECT_NEAR(document().removals().front().points.front().x, 10.0, 2.0);
  EXPECT_EQ(document().window(), window);
  EXPECT_TRUE(document().scene().removed);
  EXPECT_NE(picture(axial), before) << "a line around what is gone";
}

TEST_F(CarveWindow, TakesTheFocusAlong) {
  CarvingSettings settings = carving().settings();
  settings.size = 100.0;
  carving().setSettings(settings);
  carve(volume(0), onBall(0.0, 0.0), onBall(3.0, 0.0));
  const LabelMap& left = *document().scene().labels;
  EXPECT_EQ(document().labels()->find(marker)->value, marker) << "the labels themselves stay";
  bool isAny = false;
  for (int z = 0; z < left.grid.dims.z; ++z)
    for (int y = 0; y < left.grid.dims.y; ++y)
      for (int x = 0; x < left.grid.dims.x; ++x) isAny = isAny || left.value({x, y, z}) == marker;
  EXPECT_FALSE(isAny);
}

TEST_F(CarveWindow, LaysAPlaneAndBendsIt) {
  use(kindOf<methods::Bend>);
  EXPECT_EQ(carving().settings().shape, RemovalShape::Plane) << "the method's own";
  carve(volume(0), onBall(0.0, -25.0), onBall(2.0, 25.0));
  ASSERT_EQ(document().removals().size(), 1u);
  const Removal plane = document().removals().front();
  const Camera::Axes axes = cameras().camera(0).axes();
  EXPECT_GT(glm::dot(StrokePlane(plane.points, plane.direction).normal, axes.right), 0.8) << "to the right";
  const QImage flat = picture(volume(0));
  const int before = steps();
  const QPoint at = onBall(-4.0, 0.0);
  carve(volume(0), at, at - QPoint(25, 0), Qt::ShiftModifier);
  ASSERT_EQ(document().removals().front().bends.size(), 1u);
  EXPECT_LT(document().removals().front().bends.front().distance, 0.0) << "away from what is gone";
  EXPECT_EQ(steps(), before + 1);
  EXPECT_NE(picture(volume(0)), flat);
}

TEST_F(CarveWindow, TheBrushAndCarvingTakeTurns) {
  rows().carve()->click();
  brush().setActive(true);
  EXPECT_FALSE(carving().isActive());
  rows().carve()->click();
  EXPECT_FALSE(brush().isActive());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(carving().isActive());
}

/// While another thread has the pictures' context, as during an upload, strokes wait for it.
TEST_F(CarveWindow, StrokesWaitWhileTheContextIsTaken) {
  if (!QOpenGLContext::supportsThreadedOpenGL()) GTEST_SKIP() << "there is no OpenGL on other threads here";
  const QPoint from = onBall(-10.0, 5.0), to = onBall(12.0, 8.0);
  rows().carve()->click();
  waitUntilDrawn();
  std::atomic<bool> done{false};
  const auto end = qScopeGuard([&] {  // also where an assertion fails
    done = true;
    volume(0)->preparation().glContext().stop();
  });
  const auto takeContext = [&] {
    done = false;
    volume(0)->preparation().runBehind(
        [&](const std::atomic<bool>& stop) {
          while (!done && !stop) QThread::msleep(1);
        },
        [](std::exception_ptr) {});
    ASSERT_TRUE(volume(0)->preparation().isBusy());
  };
  takeContext();
  const Camera camera = cameras().camera(0);
  drag(volume(0), from, to);
  ASSERT_TRUE(volume(0)->preparation().isBusy());
  EXPECT_TRUE(document().removals().empty());
  EXPECT_EQ(cameras().camera(0), camera) << "the view does not turn";
  done = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().removals().size() == 1; }, patience));
  waitUntilDrawn();
  const Removal waited = document().removals().front();
  EXPECT_EQ(steps(), 1);
  document().undoStack().undo();
  waitUntilDrawn();
  drag(volume(0), from, to);
  ASSERT_EQ(document().removals().size(), 1u);
  EXPECT_EQ(waited, document().removals().front()) << "as a stroke that need not wait";
  document().undoStack().undo();
  waitUntilDrawn();

  takeContext();
  drag(volume(0), from, to);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  done = true;
  waitUntilDrawn();
  EXPECT_TRUE(document().removals().empty()) << "put down, the tool forgets what waits";
}

TEST_F(CarveWindow, PressedBesideTheVolumeItDoesNothing) {
  const Camera camera = cameras().camera(0);
  carve(volume(0), {4, 4}, {30, 4});
  EXPECT_TRUE(document().removals().empty());
  EXPECT_EQ(cameras().camera(0), camera) << "the view does not turn";
  EXPECT_EQ(steps(), 0);
}

}  // namespace
}  // namespace fenestra::viewer::carveWindowTest
