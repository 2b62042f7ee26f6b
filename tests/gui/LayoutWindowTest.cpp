// The window's size and panels: on every screen, with what a user needs in sight.

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

/// The smallest screens that the window is made for: 1024 x 700, and 1920 x 1200 at twice the density.
const QSize smallScreens[] = {{1024, 700}, {960, 600}};

/// The whole of a widget lies inside of its window and is not hidden by a tab or a scroll area.
bool isInSight(const QWidget& widget) {
  return widget.isVisible() && widget.visibleRegion().boundingRect() == widget.rect() &&
         widget.window()->rect().contains(QRect(widget.mapTo(widget.window(), QPoint(0, 0)), widget.size()));
}

}  // namespace

/// Runs on several screens, see CMakeLists.txt.
TEST_F(Window, FitsTheScreen) {
  MainWindow window({.gl = gl_, .remember = false});
  QSignalSpy opened(&window, &MainWindow::opened);
  window.open([](const io::Progress&) { return markedBall(); });
  window.show();
  ASSERT_TRUE(opened.wait(patience));
  const QRect screen = window.screen()->availableGeometry(), frame = window.frameGeometry();
  EXPECT_TRUE(screen.contains(frame)) << frame.width() << "x" << frame.height();
  for (const QSize& small : smallScreens) {
    EXPECT_LE(window.minimumSizeHint().width(), small.width());
    EXPECT_LE(window.minimumSizeHint().height(), small.height());
  }
}

TEST_F(Window, BothWidthsStayInSightOnSmallScreens) {
  for (const QSize& small : smallScreens) {
    SCOPED_TRACE(std::to_string(small.width()) + "x" + std::to_string(small.height()));
    window_->resize(small);
    // The most that the panel of the focus may hold: a grown region has rows of its own.
    document().growFrom(markerCentre);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().growth() != nullptr; }, patience));
    waitUntilDrawn();
    EXPECT_EQ(window_->size(), small);
    EXPECT_TRUE(isInSight(*window_->findChild<SliderSpin*>(QStringLiteral("open_width"))));
    EXPECT_TRUE(isInSight(*window_->findChild<SliderSpin*>(QStringLiteral("border_width"))));
    for (const VolumeView* view : views().volumeViews()) EXPECT_TRUE(isInSight(*view));
    for (const SliceView* view : views().sliceViews()) EXPECT_TRUE(isInSight(*view));
  }
}

TEST_F(Window, LightThemeIsRememberedAndLeavesPicturesAlone) {
  useScratchSettings();
  waitUntilDrawn();
  const QImage before = picture(slice(SlicePlane::Axial));
  const auto lightness = [] { return qApp->palette().color(QPalette::Window).lightness(); };
  const int dark = lightness();
  {
    MainWindow window({.gl = {.problem = QStringLiteral("slices are enough here")}});
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text().remove(QLatin1Char('&')) == QStringLiteral("Light theme")) action->trigger();
    EXPECT_GT(lightness(), dark + 100);
    EXPECT_TRUE(Preferences().isOn(Preference::LightTheme));
  }
  EXPECT_EQ(picture(slice(SlicePlane::Axial)), before);
  applyStyle(*qApp);
  EXPECT_EQ(lightness(), dark);
  {
    const MainWindow again({.gl = {.problem = QStringLiteral("slices are enough here")}});
    EXPECT_GT(lightness(), dark + 100);
  }
  Preferences().set(Preference::LightTheme, 0);
  applyStyle(*qApp);
}

TEST_F(Window, ResetLayoutBringsPanelsAndViewsBack) {
  auto* cutaway = window_->findChild<QDockWidget*>(QStringLiteral("cutawayDock"));
  auto* focus = window_->findChild<QDockWidget*>(QStringLiteral("focusDock"));
  const QSize before = volume(0)->size();
  const int width = focus->width();
  cutaway->close();
  window_->resizeDocks({focus}, {width + 150}, Qt::Horizontal);
  views().toggleMaximised(slice(SlicePlane::Axial));
  QCoreApplication::processEvents();
  EXPECT_FALSE(cutaway->isVisible());
  EXPECT_FALSE(volume(0)->isVisible());

  for (QAction* action : window_->findChildren<QAction*>())
    if (action->text().remove(QLatin1Char('&')) == QStringLiteral("Reset layout")) action->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return cutaway->isVisible() && volume(0)->isVisible(); }, patience));
  waitUntilDrawn();
  EXPECT_EQ(focus->width(), width);
  EXPECT_EQ(volume(0)->size(), before);
}

}  // namespace fenestra::viewer
