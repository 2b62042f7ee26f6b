// What shows and is not what was asked for is marked after 0.3 s, with a way to take it back, while the window answers.

#include <algorithm>
#include <functional>

#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "io/VolumeWriter.h"
#include "tests/gui/FailingDriver.h"
#include "tests/gui/HeldThreads.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/LoadingBar.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/exports/Exports.h"
#include "viewer/exports/Verification.h"
#include "viewer/model/Fidelity.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelEditPanel.h"

namespace fenestra::viewer::busyWindowTest {
namespace {

class BusyWindow : public Window {
 protected:
  QWidget* bar() { return window_->findChild<QWidget*>(QStringLiteral("waitingBar")); }
  LabelEditPanel& edits() { return *panel<FocusPanel>().labelEdits(); }
  /// The bar of a job that runs; null: none runs.
  LoadingBar* shownJob() {
    const auto bars = window_->findChildren<LoadingBar*>();
    const auto shown = std::find_if(bars.begin(), bars.end(), [](const LoadingBar* each) { return each->isVisible(); });
    return shown == bars.end() ? nullptr : *shown;
  }
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

TEST_F(BusyWindow, Thorough_APictureThatIsBehindIsMarkedUntilItIsThere) {
  const SlowCompiler driver;
  askFor(kindOf<methods::ContextPreserving>);
  EXPECT_FALSE(isMarked(volume(0))) << "a short wait is no news";
  ASSERT_TRUE(QTest::qWaitFor([&] { return isMarked(volume(0)) && isMarked(volume(1)); }, patience));
  EXPECT_TRUE(bar()->isVisible());
  waitUntilDrawn();
  EXPECT_FALSE(isMarked(volume(0)));
  EXPECT_FALSE(bar()->isVisible());
}

TEST_F(BusyWindow, WhatIsAwaitedCanBeTakenBack) {
  const Look before = document().look();
  const SlowCompiler driver;
  askFor(kindOf<methods::ContextPreserving>);
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar()->isVisible(); }, patience));
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
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar()->isVisible(); }, patience));
  QTest::mouseClick(bar()->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_FALSE(cameras().frozen()[0]);
  EXPECT_TRUE(document().isFocused(marker)) << "what showed before stays";
  waitUntilDrawn();
}

TEST_F(BusyWindow, AllViewsAreMarkedWhileALabelIsEdited) {
  document().focusOn(marker);
  waitUntilDrawn();
  const auto areMarked = [&] {
    return isMarked(volume(0)) && isMarked(volume(1)) &&
           linesOf(slice(SlicePlane::Axial)->fidelity()).contains(QStringLiteral("not yet what was asked for"));
  };
  HeldThreads threads;
  QTest::mouseClick(edits().button(LabelOperation::Grow), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor(areMarked, patience));
  EXPECT_FALSE(bar()->isVisible()) << "the bar of the edit shows";
  EXPECT_TRUE(shownJob());
  threads.release();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shownJob(); }, patience));
  waitUntilDrawn();
  EXPECT_FALSE(isMarked(volume(0)) || isMarked(volume(1)));
  EXPECT_FALSE(linesOf(slice(SlicePlane::Axial)->fidelity()).contains(QStringLiteral("not yet what was asked for")));
}

/// A job that the window can be asked for, and what its bar says before the job runs.
struct AskedJob {
  const char* says;
  std::function<void()> ask;
};

TEST_F(BusyWindow, EachJobHasABarThatCancelsIt) {
  const std::filesystem::path folder = tests::scratchFolder(), ball = folder / "ball.nii", mask = folder / "mask.nii",
                              copy = folder / "copy.nii";
  document().focusOn(marker);
  waitUntilDrawn();
  window_->exports().writeLabels(mask, Exports::Labels::All);
  io::writeVolume(*document().scene().volume, ball);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shownJob(); }, patience));
  const AskedJob jobs[] = {
      {"Opening…", [&] { window_->open({ball}); }},
      {"Opening…", [&] { window_->openLabels(mask); }},
      {"Writing…", [&] { window_->exports().writeLabels(copy, Exports::Labels::All); }},
      {"Editing the label", [&] { edits().button(LabelOperation::Grow)->click(); }},
      {"Verifying the picture", [&] { window_->verification().start(); }},
      {"Growing the region", [&] { document().growFrom(markerCentre); }},
  };
  const std::shared_ptr<const Volume> shown = document().scene().volume;
  const std::shared_ptr<const LabelMap> labels = document().labels();
  for (const AskedJob& job : jobs) {
    SCOPED_TRACE(job.says);
    waitUntilDrawn();  // only a finished picture is verified
    HeldThreads threads;
    job.ask();
    LoadingBar* its = shownJob();
    ASSERT_TRUE(its);
    EXPECT_EQ(its->findChild<QLabel*>()->text(), QString::fromUtf8(job.says));
    QTest::mouseClick(its->findChild<QPushButton*>(), Qt::LeftButton);
    threads.release();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !shownJob(); }, patience));
    EXPECT_EQ(document().scene().volume, shown);
    EXPECT_EQ(document().labels(), labels);
    EXPECT_TRUE(document().isFocused(marker));
    EXPECT_FALSE(std::filesystem::exists(copy));
    EXPECT_EQ(window_->notices().texts(), QStringList());
  }
}

TEST_F(BusyWindow, AFirstStudyIsReadWhileTheWindowIsBuilt) {
  HeldThreads threads;
  MainWindow window(
      {.gl = {.problem = QStringLiteral("slices are enough here")},
       .remember = false,
       .openFirst = [](MainWindow& opening) { opening.open([](const io::Progress&) { return markedBall(); }); }});
  QSignalSpy opened(&window, &MainWindow::opened);
  window.show();
  const auto bars = window.findChildren<LoadingBar*>();
  const auto its = std::find_if(bars.begin(), bars.end(), [](const LoadingBar* each) { return each->isVisible(); });
  ASSERT_NE(its, bars.end());
  EXPECT_EQ((*its)->findChild<QLabel*>()->text(), QString::fromUtf8("Opening…"));
  threads.release();
  EXPECT_TRUE(opened.wait(patience));
  EXPECT_FALSE((*its)->isVisible());
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
  EXPECT_TRUE(QToolTip::text().startsWith(QStringLiteral("approximate")));
  EXPECT_EQ(pointAt(slice(SlicePlane::Coronal), {15, 16}), QStringLiteral("faithful"));
}

TEST_F(BusyWindow, TheChipOfEachViewHasTheColourOfItsGrade) {
  const auto chip = [&](QWidget* view) {
    const QImage image = picture(view);
    return image.pixelColor(QPointF(8.0, 10.0).toPoint() * image.devicePixelRatio());
  };
  EXPECT_EQ(chip(volume(0)), QColor(200, 205, 210)) << "without a bound";
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
}  // namespace fenestra::viewer::busyWindowTest
