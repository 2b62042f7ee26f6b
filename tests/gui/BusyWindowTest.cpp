// What shows and is not what was asked for is marked after 0.3 s, with a way to take it back, while the window answers.

#include <QApplication>
#include <QHelpEvent>
#include <QPushButton>
#include <QTest>
#include <QToolTip>

#include "tests/gui/FailingDriver.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/model/Fidelity.h"

namespace fenestra::viewer {
namespace {

class BusyWindow : public Window {
 protected:
  QWidget* bar() { return window_->findChild<QWidget*>(QStringLiteral("waitingBar")); }
  bool isMarked(VolumeView* view) {
    return linesOf(view->fidelity()).contains(QStringLiteral("not yet what was asked for"));
  }
  /// Asks for a look whose programs are not there and whose driver is slow.
  void askFor(MethodKind kind) {
    Look look = document().look();
    look.focus = LabelFocus{{marker}};
    look.method.kind = kind;
    document().edit(QStringLiteral("Method"), look);
  }
};

TEST_F(BusyWindow, APictureThatIsBehindIsMarkedUntilItIsThere) {
  const SlowCompiler driver;
  askFor(kindOf<methods::ContextPreserving>);
  EXPECT_FALSE(isMarked(volume(0))) << "a short wait is no news";
  ASSERT_TRUE(QTest::qWaitFor([&] { return isMarked(volume(0)) && isMarked(volume(1)); }, 5000));
  EXPECT_TRUE(bar()->isVisible());
  waitUntilDrawn();
  EXPECT_FALSE(isMarked(volume(0)));
  EXPECT_FALSE(bar()->isVisible());
}

TEST_F(BusyWindow, WhatIsAwaitedCanBeTakenBack) {
  const Look before = document().look();
  const SlowCompiler driver;
  askFor(kindOf<methods::ContextPreserving>);
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar()->isVisible(); }, 5000));
  QTest::mouseClick(bar()->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_EQ(document().look(), before);
  waitUntilDrawn();
  EXPECT_FALSE(isMarked(volume(0)));
}

TEST_F(BusyWindow, AFreezeThatIsAwaitedCanBeTakenBack) {
  document().focusOn(marker);
  waitUntilDrawn();
  const SlowCompiler driver;
  cameras().setFrozen({OpeningView{cameras().camera(0), {100, 100}, 1.0}, std::nullopt});
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar()->isVisible(); }, 5000));
  QTest::mouseClick(bar()->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_FALSE(cameras().frozen()[0]);
  EXPECT_TRUE(document().isFocused(marker)) << "what showed before stays";
  waitUntilDrawn();
}

TEST_F(BusyWindow, AllViewsAreMarkedWhileALabelIsEdited) {
  views().setAwaits(true);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return isMarked(volume(0)) &&
               linesOf(slice(SlicePlane::Axial)->fidelity()).contains(QStringLiteral("not yet what was asked for"));
      },
      5000));
  EXPECT_FALSE(bar()->isVisible()) << "the bar of the edit shows";
  views().setAwaits(false);
  EXPECT_FALSE(isMarked(volume(0)));
  EXPECT_TRUE(slice(SlicePlane::Axial)->fidelity().empty());
}

TEST_F(BusyWindow, AMovingPictureIsADraft) {
  cameras().orbit(0, 0.3, 0.0);
  EXPECT_TRUE(linesOf(volume(0)->fidelity()).join(QLatin1Char('\n')).contains(QStringLiteral("draft while")));
  waitUntilDrawn();
  EXPECT_FALSE(linesOf(volume(0)->fidelity()).join(QLatin1Char('\n')).contains(QStringLiteral("draft while")));
}

TEST_F(BusyWindow, PointingAtTheChipSaysWhy) {
  const auto pointAt = [](QWidget* view, QPoint at) {
    QHelpEvent help(QEvent::ToolTip, at, view->mapToGlobal(at));
    QApplication::sendEvent(view, &help);
    return QToolTip::text();
  };
  EXPECT_EQ(pointAt(volume(0), {15, 16}), linesOf(volume(0)->fidelity()).join(QLatin1Char('\n')));
  EXPECT_TRUE(QToolTip::text().startsWith(QStringLiteral("altered")));
  EXPECT_EQ(pointAt(slice(SlicePlane::Coronal), {15, 16}), QStringLiteral("faithful"));
}

TEST_F(BusyWindow, TheChipOfEachViewHasTheColourOfItsGrade) {
  const auto chip = [&](QWidget* view) {
    const QImage image = picture(view);
    return image.pixelColor(QPointF(8.0, 10.0).toPoint() * image.devicePixelRatio());
  };
  EXPECT_EQ(chip(volume(0)), QColor(240, 190, 70)) << "a draft has no bound";
  EXPECT_EQ(chip(slice(SlicePlane::Axial)), QColor(110, 200, 130));
  views().setAtRest(Quality::Normal, 4.0);
  waitUntilDrawn();
  EXPECT_EQ(chip(volume(0)), QColor(110, 180, 240));
  views().setAtRest(Quality::Normal, 0.5);
  waitUntilDrawn();
  EXPECT_EQ(chip(volume(0)), QColor(110, 200, 130));
  volume(0)->noteVerified(QStringLiteral("all pixels"));
  EXPECT_TRUE(linesOf(volume(0)->fidelity()).contains(QStringLiteral("verified: all pixels")));
  cameras().orbit(0, 0.2, 0.0);
  waitUntilDrawn();
  EXPECT_TRUE(linesOf(volume(0)->fidelity()).contains(QStringLiteral("not verified"))) << "another picture";
}

}  // namespace
}  // namespace fenestra::viewer
