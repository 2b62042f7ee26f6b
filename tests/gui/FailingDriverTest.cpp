// A driver that fails takes the 3-D views away and nothing else.

#include <QApplication>
#include <QMouseEvent>
#include <QTest>

#include "tests/gui/FailingDriver.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/panels/CamerasPanel.h"

namespace fenestra::viewer::failingDriverTest {
namespace {

/// A window whose user goes on working after OpenGL has failed.
class FailingWindow : public Window {
 protected:
  /// Each view shows the same problem in one line, and the window tells it once.
  void expectOneMessage(const QString& part) {
    QApplication::processEvents();  // the window is told after the picture
    ASSERT_EQ(window_->notices().texts().size(), 1) << window_->notices().texts().join(QLatin1Char('\n')).toStdString();
    const QString message = window_->notices().texts().front();
    EXPECT_TRUE(message.contains(part)) << message.toStdString();
    EXPECT_FALSE(message.contains(QLatin1Char('\n')));
    for (const VolumeView* view : views().volumeViews()) EXPECT_EQ(view->problem(), message);
  }

  /// Every way in which a 3-D view calls the renderer.
  void useView(VolumeView* view) {
    const QPoint middle = view->rect().center();
    QTest::mouseClick(view, Qt::LeftButton, {}, middle);
    QTest::mouseClick(view, Qt::LeftButton, Qt::ControlModifier, middle);
    QTest::mouseClick(view, Qt::RightButton, {}, middle);
    drag(view, middle, middle + QPoint(20, 10));
    wheel(view, 1);
    moveOver(view, middle, Qt::ShiftModifier);
    brush().setActive(true);
    moveOver(view, middle, {});
    drag(view, middle, middle + QPoint(10, 10));
    brush().setActive(false);
    waitUntilDrawn();
  }

  void moveOver(QWidget* view, QPoint at, Qt::KeyboardModifiers modifiers) {
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::NoButton, modifiers);
    QApplication::sendEvent(view, &move);
  }

  void expectSlicesWork() {
    SliceView* axial = slice(SlicePlane::Axial);
    cursor().moveTo(markerCentre);
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->widgetFromWorld(markerCentre).toPoint());
    EXPECT_TRUE(document().isFocused(marker));
    waitUntilDrawn();
    EXPECT_TRUE(green(axial)) << "the marker is not seen";
  }
};

/// Refused from the first shader on.
class RefusedWindow : public FailingWindow {
  RefusingDriver driver_;
};

TEST_F(RefusedWindow, SaysSoOnceAndKeepsTheSlices) {
  expectOneMessage(QStringLiteral("LIBGL_ALWAYS_SOFTWARE"));
  const glm::dvec3 before = cursor().position();
  for (VolumeView* view : views().volumeViews()) useView(view);
  EXPECT_EQ(cursor().position(), before) << "there is nothing to click on";
  EXPECT_TRUE(document().strokes().empty());
  expectSlicesWork();
  expectOneMessage(QStringLiteral("LIBGL_ALWAYS_SOFTWARE"));
  EXPECT_FALSE(window_->picture().isNull());
}

TEST_F(RefusedWindow, SaysThatCamerasCannotBePlaced) {
  document().focusOn(marker);
  QTest::keyClick(window_.get(), Qt::Key_F5);
  waitUntilDrawn();
  EXPECT_EQ(placement().measured(), nullptr);
  EXPECT_TRUE(placement().note().contains(QStringLiteral("graphics driver"))) << placement().note().toStdString();
  EXPECT_FALSE(placement().note().contains(QLatin1Char('\n')));
}

TEST_F(FailingWindow, RefusesShadersOfALaterPicture) {
  {
    const RefusingDriver driver;
    // An opening along another axis has shaders of its own, which nothing compiles ahead.
    document().focusOn(marker);
    Look tilted = document().look();
    tilted.cutaway.axisOffset = 20.0;
    document().edit(QStringLiteral("axis"), tilted);
    waitUntilDrawn();
    expectOneMessage(QStringLiteral("LIBGL_ALWAYS_SOFTWARE"));
    for (VolumeView* view : views().volumeViews()) useView(view);
    expectSlicesWork();
  }
  open(markedBall());
  EXPECT_TRUE(window_->notices().texts().isEmpty());
  for (const std::size_t view : {0u, 1u}) {
    EXPECT_TRUE(volume(view)->problem().isEmpty());
    EXPECT_TRUE(volume(view)->isSettled());
  }
}

TEST_F(FailingWindow, RefusesShadersThatMeasureCandidates) {
  document().focusOn(marker);
  waitUntilDrawn();
  const RefusingDriver driver;
  placement().place();
  waitUntilDrawn();
  EXPECT_EQ(placement().measured(), nullptr);
  EXPECT_TRUE(placement().note().contains(QStringLiteral("graphics driver"))) << placement().note().toStdString();
  for (const std::size_t view : {0u, 1u}) EXPECT_TRUE(volume(view)->problem().isEmpty()) << "the pictures are drawn";
}

TEST_F(FailingWindow, FailsInAClick) {
  const ForgetfulDriver driver;
  const glm::dvec3 before = cursor().position();
  for (VolumeView* view : views().volumeViews()) useView(view);
  EXPECT_EQ(cursor().position(), before);
  expectOneMessage(QStringLiteral("no graphics memory"));
  expectSlicesWork();
}

TEST_F(FailingWindow, FailsUnderTheBrush) {
  const ForgetfulDriver driver;
  brush().setActive(true);
  for (VolumeView* view : views().volumeViews()) {
    const QPoint middle = view->rect().center();
    drag(view, middle, middle + QPoint(10, 10));
  }
  brush().setActive(false);
  waitUntilDrawn();
  EXPECT_TRUE(document().strokes().empty());
  expectOneMessage(QStringLiteral("no graphics memory"));
  expectSlicesWork();
}

TEST_F(FailingWindow, LeavesTheBestViewsWithoutPictures) {
  auto& cameras = panel<CamerasPanel>();
  document().focusOn(marker);
  placement().place();
  waitUntilDrawn();
  ASSERT_NE(placement().measured(), nullptr);
  const RefusingDriver driver;
  cameras.parentWidget()->raise();
  cameras.window()->activateWindow();
  waitUntilDrawn();
  EXPECT_FALSE(cameras.bestViews().isDrawing());
  QTest::mouseClick(cameras.bestViews().button(1), Qt::LeftButton);
  waitUntilDrawn();
  const glm::dvec3 wanted = placement().measured()->candidates[placement().best(BestViews::count)[1]].direction;
  EXPECT_GT(glm::dot(directionOf(this->cameras().camera(0)), wanted), 1.0 - 1e-9);
}

/// A volume that is too large for the device.
class ReducedWindow : public FailingWindow {
 protected:
  SmallDriver driver_;  // before the window opens a study
};

TEST_F(ReducedWindow, NamesTheFactorAndShowsEveryVoxelInSlices) {
  waitUntilDrawn();
  QApplication::processEvents();
  ASSERT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("2×2×2 voxels as one")))
      << window_->notices().texts().front().toStdString();
  EXPECT_EQ(slice(SlicePlane::Axial)->sliceGeometry().width, 48);
  expectSlicesWork();
  for (VolumeView* view : views().volumeViews()) EXPECT_TRUE(green(view)) << "the focus is not seen";
}

}  // namespace
}  // namespace fenestra::viewer::failingDriverTest
