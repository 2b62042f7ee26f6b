// The window's size and panels: on every screen, with what a user needs in sight.

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/gui/WindowFixture.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelList.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer::layoutWindowTest {
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

namespace {

/// The heights of the docks in the column, from top to bottom.
std::vector<int> dockHeights(const QMainWindow& window) {
  std::vector<int> heights;
  for (const char* name : {"focusDock", "contextDock", "cutawayDock"})
    heights.push_back(window.findChild<QDockWidget*>(QLatin1String(name))->height());
  return heights;
}

}  // namespace

TEST_F(Window, EachPanelOfTheColumnHasAUsefulHeight) {
  const auto& appearance = panel<AppearancePanel>();
  const auto& structures = *panel<FocusPanel>().list();
  for (const QSize& size : {QSize(1024, 700), QSize(1600, 1000), QSize(1920, 1200), QSize(1024, 700)}) {
    SCOPED_TRACE(std::to_string(size.width()) + "x" + std::to_string(size.height()));
    window_->resize(size);
    waitUntilDrawn();
    ASSERT_EQ(window_->size(), size);
    EXPECT_TRUE(isInSight(panel<CutawayPanel>()));
    EXPECT_TRUE(isInSight(*appearance.presets().box()));
    EXPECT_TRUE(isInSight(*appearance.shift()));
    const int row = structures.visualRect(structures.model()->index(0, 0)).height();
    EXPECT_GE(structures.viewport()->visibleRegion().boundingRect().height(), 2 * row);
    EXPECT_GE(appearance.editor().plot().visibleRegion().boundingRect().height(), 40);
    if (size.height() < 1000) continue;
    EXPECT_TRUE(isInSight(appearance.editor().plot()));
    EXPECT_TRUE(isInSight(*appearance.editor().value()));
    EXPECT_GE(structures.viewport()->height(), 5 * row);
    if (size.height() < 1200) continue;
    EXPECT_TRUE(isInSight(*appearance.findChild<QWidget*>(QStringLiteral("background")))) << "its last row";
  }
}

TEST_F(Window, AFoldedPanelKeepsItsTitleAlone) {
  useScratchSettings();
  const MainWindow::Setup setup{.gl = {.problem = QStringLiteral("slices are enough here")}};
  {
    MainWindow window(setup);
    QSignalSpy opened(&window, &MainWindow::opened);
    window.open([](const io::Progress&) { return markedBall(); });
    window.resize(1366, 720);  // a small laptop's screen, without the desktop's bar
    window.show();
    ASSERT_TRUE(opened.wait(patience));
    auto* context = window.findChild<QDockWidget*>(QStringLiteral("contextDock"));
    auto* fold = context->findChild<QToolButton*>(QStringLiteral("fold"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return isInSight(*fold); }, patience));
    QTest::mouseClick(fold, Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return context->height() < 40; }, patience)) << context->height();
    EXPECT_TRUE(isInSight(*window.findChild<SliderSpin*>(QStringLiteral("open_width")))) << "others stay";
    window.close();
  }
  MainWindow again(setup);
  again.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&again, patience));
  auto* context = again.findChild<QDockWidget*>(QStringLiteral("contextDock"));
  EXPECT_TRUE(context->widget()->isHidden()) << "the next start has it folded";
  context->findChild<QToolButton*>(QStringLiteral("fold"))->click();
  EXPECT_FALSE(context->widget()->isHidden());
  EXPECT_TRUE(QTest::qWaitFor([&] { return context->height() > 150; }, patience));
}

TEST_F(Window, HeightsOfPanelsAreTheUsersOnceABorderWasDragged) {
  useScratchSettings();
  MainWindow::Setup setup{.gl = {.problem = QStringLiteral("slices are enough here")}};
  std::vector<int> chosen;
  {
    MainWindow window(setup);
    window.resize(1600, 1000);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
    const std::vector<int> first = dockHeights(window);
    auto* context = window.findChild<QDockWidget*>(QStringLiteral("contextDock"));
    window.resizeDocks({context}, {first[1] - 60}, Qt::Vertical);  // as dragging its border does
    QCoreApplication::processEvents();
    chosen = dockHeights(window);
    ASSERT_LT(chosen[1], first[1] - 30);
    window.resize(1600, 1010);
    QCoreApplication::processEvents();
    EXPECT_LT(dockHeights(window)[1], first[1] - 30) << "a larger window keeps what was chosen";
    window.resize(1600, 1000);
    QCoreApplication::processEvents();
    window.close();
  }
  MainWindow again(setup);
  again.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&again, patience));
  QCoreApplication::processEvents();
  for (std::size_t i = 0; i < chosen.size(); ++i)
    EXPECT_NEAR(dockHeights(again)[i], chosen[i], 12) << "and so does the next start";
  for (QAction* action : again.findChildren<QAction*>())
    if (action->text().remove(QLatin1Char('&')) == QStringLiteral("Reset layout")) action->trigger();
  QCoreApplication::processEvents();
  EXPECT_TRUE(isInSight(again.findChild<AppearancePanel*>()->editor().plot())) << "shared anew";
  EXPECT_GT(dockHeights(again)[1], chosen[1] + 30);
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

}  // namespace fenestra::viewer::layoutWindowTest
