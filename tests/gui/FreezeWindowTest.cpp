// Freezing the opening in the window: command, undo, slices, sessions, and the axis offset's controls.

#include <QAction>
#include <QDoubleSpinBox>
#include <QTest>
#include <QToolButton>

#include "io/session/Session.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer::freezeWindowTest {
namespace {

class FreezeWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (HasFatalFailure() || IsSkipped()) return;
    setAutomatic(false);
    document().focusOn(marker);
    waitUntilDrawn();
  }
  void press(Qt::Key key) { QTest::keyClick(window_.get(), key); }
  /// Where C1's opening is cut, as the slices get it.
  std::shared_ptr<const RayStarts> startsAfter(const std::function<void()>& does) {
    std::shared_ptr<const RayStarts> last;
    const auto connection = QObject::connect(volume(0), &VolumeView::raysStarted,
                                             [&](const std::shared_ptr<const RayStarts>& starts) { last = starts; });
    does();
    EXPECT_TRUE(QTest::qWaitFor([&] { return last != nullptr; }, patience));
    QObject::disconnect(connection);
    return last;
  }
};

TEST_F(FreezeWindow, Thorough_KeepsTheOpeningWhileTheCamerasMove) {
  const View before = volume(0)->restView();
  EXPECT_FALSE(before.frozen);
  press(Qt::Key_F);
  waitUntilDrawn();
  ASSERT_TRUE(volume(0)->restView().frozen && volume(1)->restView().frozen);
  EXPECT_EQ(volume(0)->restView().frozen->camera, before.camera);
  EXPECT_TRUE(window_->findChild<QAction*>(QStringLiteral("freeze"))->isChecked());
  const auto starts = startsAfter([this] { cameras().orbit(0, 0.5, 0.2); });
  ASSERT_TRUE(starts);
  EXPECT_EQ(starts->camera, before.camera) << "of the opening that the slices draw";
  EXPECT_NE(volume(0)->restView().camera, before.camera);
  const QImage frozen = picture(volume(0));
  press(Qt::Key_F);
  waitUntilDrawn();
  EXPECT_FALSE(cameras().isFrozen());
  EXPECT_NE(picture(volume(0)), frozen);
}

TEST_F(FreezeWindow, IsAStepOfTheHistory) {
  press(Qt::Key_F);
  const ViewLink::Frozen frozen = cameras().frozen();
  document().undoStack().undo();
  EXPECT_FALSE(cameras().isFrozen());
  document().undoStack().redo();
  EXPECT_EQ(cameras().frozen(), frozen);
}

TEST_F(FreezeWindow, AnotherStudyIsNotFrozen) {
  press(Qt::Key_F);
  open(markedBall());
  EXPECT_FALSE(cameras().isFrozen());
}

TEST_F(FreezeWindow, Thorough_ThePanelTiltsTheOpening) {
  auto& cutaway = panel<CutawayPanel>();
  auto* offset = cutaway.findChild<SliderSpin*>(QStringLiteral("axis_offset"));
  auto* direction = cutaway.findChild<QDoubleSpinBox*>(QStringLiteral("axis_direction"));
  ASSERT_TRUE(offset && direction);
  EXPECT_FALSE(direction->isEnabled());
  const QImage straight = picture(volume(0));
  offset->box()->setValue(35.0);
  EXPECT_EQ(document().look().cutaway.axisOffset, 35.0);
  EXPECT_TRUE(direction->isEnabled());
  waitUntilDrawn();
  const QImage right = picture(volume(0));
  EXPECT_NE(right, straight);
  direction->setValue(90.0);
  EXPECT_EQ(document().look().cutaway.axisDirection, 90.0);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), right);
  document().undoStack().undo();
  document().undoStack().undo();
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), straight);
  EXPECT_NE(cutaway.findChild<QToolButton*>(), nullptr) << "to freeze";
}

}  // namespace
}  // namespace fenestra::viewer::freezeWindowTest
