// The window's size and panels: on every screen, with what a user needs in sight.

#include <algorithm>
#include <initializer_list>
#include <memory>

#include <QtTest/qtestspontaneevent.h>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QMouseEvent>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "rendering/methods/Method.h"
#include "tests/gui/CutTexts.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelList.h"
#include "viewer/panels/RegionPanel.h"
#include "viewer/panels/SphereMap.h"
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
    const int row = structures.visualRect(structures.model()->index(0, 0)).height();
    EXPECT_GE(structures.viewport()->visibleRegion().boundingRect().height(), 8 * row);
    if (size.height() < 1000) continue;
    EXPECT_TRUE(isInSight(*appearance.presets().box()));
    EXPECT_TRUE(isInSight(*appearance.shift()));
    EXPECT_TRUE(isInSight(appearance.editor().plot()));
    EXPECT_TRUE(isInSight(*appearance.editor().value()));
  }
}

namespace {

/// The marked ball with twenty more labels, a voxel each.
io::Study studyOfManyLabels() {
  io::Study study = markedBall();
  const LabelMap& ball = *study.scene.labels;
  auto labels = std::make_shared<LabelMap>();
  labels->grid = ball.grid;
  labels->labels = ball.labels;
  labels->voxels = Voxels(ScalarType::UInt8, labels->grid.voxelCount());
  auto marks = labels->voxels.as<std::uint8_t>();
  const auto from = ball.voxels.as<std::uint8_t>();
  std::copy(from.begin(), from.end(), marks.begin());
  for (int more = 3; more < 23; ++more) {
    marks[labels->grid.offset({more, 4, 4})] = static_cast<std::uint8_t>(more);
    labels->labels.push_back({static_cast<std::uint16_t>(more), "structure " + std::to_string(more), {1.0, 0.5, 0.2}});
  }
  study.scene.labels = labels;
  return study;
}

class Sections : public Window {
 protected:
  QDockWidget* dock(const char* name) { return window_->findChild<QDockWidget*>(QLatin1String(name)); }
  bool isOpen(const char* name) { return dock(name)->widget()->isVisible(); }
  void clickTitle(const char* name) {
    QTest::mouseClick(dock(name), Qt::LeftButton, {}, QPoint(40, 10));
    settle();
  }
  /// The layout has followed all that it was told.
  static void settle() {
    for (int round = 0; round < 5; ++round) {
      QCoreApplication::sendPostedEvents();
      QCoreApplication::processEvents();
    }
  }
  int rowsInSight() {
    LabelList& list = *panel<FocusPanel>().list();
    return list.viewport()->visibleRegion().boundingRect().height() /
           list.visualRect(list.model()->index(0, 0)).height();
  }
  /// Controls of a panel that are cut off, with their names.
  QStringList cutOff(const QWidget& panel) {
    QStringList found;
    for (const QWidget* child : panel.findChildren<QWidget*>())
      if (child->focusPolicy() != Qt::NoFocus && child->isVisibleTo(&panel) && !isInSight(*child))
        found << placeOf(child);
    return found;
  }
  QPoint placeInWindow(const QWidget& widget) { return widget.mapTo(window_.get(), QPoint(0, 0)); }
  /// No control moves when a method with other rows is chosen, also where the panel is scrolled down.
  void expectMethodStays(QComboBox& method, QScrollArea& scroller) {
    for (const bool down : {false, true})
      for (int kind = 1; kind <= method.count(); ++kind) {
        scroller.verticalScrollBar()->setValue(down ? scroller.verticalScrollBar()->maximum() : 0);
        const QPoint box = placeInWindow(method), title = placeInWindow(*dock("cutawayDock"));
        method.setCurrentIndex(kind % method.count());
        Q_EMIT method.activated(method.currentIndex());
        settle();
        EXPECT_EQ(placeInWindow(method), box) << method.currentText().toStdString();
        EXPECT_EQ(placeInWindow(*dock("cutawayDock")), title) << method.currentText().toStdString();
      }
    scroller.verticalScrollBar()->setValue(0);
  }
  /// A wheel event as the window system sends it: Qt hands no other one on to parents.
  static void wheelFromScreen(QWidget& widget, int notches) {
    const QPointF at = widget.rect().center();
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&widget, &event);
  }
  void expectButtonsStay(FocusPanel& focus) {
    for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{focus.byValue(), focus.paint()}) {
      focus.ensureWidgetVisible(button);
      settle();
      const QPoint place = placeInWindow(*button);
      for (int click = 0; click < 2; ++click) {
        QTest::mouseClick(button, Qt::LeftButton);
        settle();
        EXPECT_EQ(placeInWindow(*button), place) << button->text().toStdString();
      }
    }
  }
};

}  // namespace

/// All that a small laptop's screen must show, and nothing that moves under the mouse.
TEST_F(Sections, Thorough_FitASmallLaptop) {
  open(studyOfManyLabels());
  document().focusOn(marker);
  window_->resize(1366, 768);
  waitUntilDrawn();
  settle();
  ASSERT_EQ(window_->size(), QSize(1366, 768));
  int above = 0;
  for (const char* name : {"focusDock", "cutawayDock", "contextDock", "camerasDock"}) {
    EXPECT_GT(dock(name)->y(), above) << name << " in the order of work";
    EXPECT_TRUE(isInSight(*dock(name))) << name;
    above = dock(name)->y();
  }
  EXPECT_GE(rowsInSight(), 8);
  CutawayPanel& cutaway = panel<CutawayPanel>();
  EXPECT_EQ(cutOff(cutaway).join(QLatin1Char(' ')).toStdString(), "");
  EXPECT_FALSE(isOpen("contextDock"));
  EXPECT_FALSE(isOpen("camerasDock"));

  auto& method = *cutaway.findChild<QComboBox*>(QStringLiteral("kind"));
  auto& scroller = dynamic_cast<QScrollArea&>(*dock("cutawayDock")->widget());
  expectMethodStays(method, scroller);

  // The wheel scrolls the panel, unless the slider has the focus.
  method.setCurrentIndex(method.findData(static_cast<int>(kindOf<methods::Importance>)));
  Q_EMIT method.activated(method.currentIndex());
  settle();
  SliderSpin& width = *cutaway.findChild<SliderSpin*>(QStringLiteral("border_width"));
  const double before = width.value();
  method.setFocus();
  wheelFromScreen(*width.slider(), -1);
  EXPECT_EQ(width.value(), before);
  EXPECT_GT(scroller.verticalScrollBar()->value(), 0);
  LabelList& list = *panel<FocusPanel>().list();
  wheel(list.viewport(), -1);
  EXPECT_GT(list.verticalScrollBar()->value(), 0);

  FocusPanel& focus = panel<FocusPanel>();
  expectButtonsStay(focus);

  // Another section has the room of the one that is done with, and shows its plot whole.
  clickTitle("contextDock");
  EXPECT_TRUE(isOpen("contextDock"));
  EXPECT_FALSE(isOpen("cutawayDock"));
  const AppearancePanel& look = panel<AppearancePanel>();
  EXPECT_TRUE(isInSight(look.editor().plot()));
  EXPECT_TRUE(isInSight(*look.editor().value()));
  focus.verticalScrollBar()->setValue(0);
  EXPECT_GE(rowsInSight(), 8);
  clickTitle("camerasDock");
  EXPECT_TRUE(isInSight(*panel<CamerasPanel>().map()));
  EXPECT_GE(rowsInSight(), 8);
  clickTitle("cutawayDock");
  EXPECT_TRUE(isInSight(width));

  // A region's plot comes into sight with it.
  document().growFrom(markerCentre);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().growth() != nullptr; }, patience));
  settle();
  EXPECT_TRUE(isInSight(*focus.region()->plot()));
  EXPECT_TRUE(isInSight(*focus.region()->slider()));
}

TEST_F(Sections, ThoseOpenedLastAreOpenAtTheNextStart) {
  useScratchSettings();
  const MainWindow::Setup setup{.gl = {.problem = QStringLiteral("slices are enough here")}};
  const auto isOpenIn = [](MainWindow& window, const char* name) {
    return !window.findChild<QDockWidget*>(QLatin1String(name))->widget()->isHidden();
  };
  {
    MainWindow window(setup);
    window.resize(1366, 720);
    window.show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !isOpenIn(window, "camerasDock"); }, patience)) << "no room for it";
    EXPECT_TRUE(isOpenIn(window, "cutawayDock"));
    auto* cameras = window.findChild<QDockWidget*>(QStringLiteral("camerasDock"));
    cameras->findChild<QToolButton*>(QStringLiteral("fold"))->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !isOpenIn(window, "cutawayDock"); }, patience));
    window.close();
  }
  MainWindow again(setup);
  again.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !isOpenIn(again, "cutawayDock"); }, patience));
  EXPECT_TRUE(isOpenIn(again, "camerasDock"));
  again.findChild<QAction*>(QStringLiteral("resetLayout"))->trigger();
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return isOpenIn(again, "cutawayDock") && !isOpenIn(again, "camerasDock"); }, patience));
}

TEST_F(Window, AFoldedPanelKeepsItsTitleAlone) {
  useScratchSettings();
  const MainWindow::Setup setup{.gl = {.problem = QStringLiteral("slices are enough here")}};
  {
    QMainWindow older;
    auto* hidden = new QDockWidget(&older);
    hidden->setObjectName(QStringLiteral("cutawayDock"));
    older.addDockWidget(Qt::LeftDockWidgetArea, hidden);
    hidden->hide();
    constexpr int version = 5;  // before the panels were one column
    Preferences().setLayout({}, older.saveState(version), {});
  }
  {
    MainWindow window(setup);
    QSignalSpy opened(&window, &MainWindow::opened);
    window.open([](const io::Progress&) { return markedBall(); });
    window.resize(1366, 720);  // a small laptop's screen, without the desktop's bar
    window.show();
    ASSERT_TRUE(opened.wait(patience));
    auto* cutaway = window.findChild<QDockWidget*>(QStringLiteral("cutawayDock"));
    EXPECT_TRUE(cutaway->isVisible()) << "the layout of an older version is none of this one's";
    auto* fold = cutaway->findChild<QToolButton*>(QStringLiteral("fold"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return isInSight(*fold); }, patience));
    QTest::mouseClick(fold, Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return cutaway->height() < 40; }, patience)) << cutaway->height();
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return isInSight(window.findChild<AppearancePanel*>()->editor().plot()); }, patience))
        << "another has its room";
    window.close();
  }
  MainWindow again(setup);
  again.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&again, patience));
  auto* cutaway = again.findChild<QDockWidget*>(QStringLiteral("cutawayDock"));
  EXPECT_TRUE(cutaway->widget()->isHidden()) << "the next start has it folded";
  cutaway->findChild<QToolButton*>(QStringLiteral("fold"))->click();
  EXPECT_FALSE(cutaway->widget()->isHidden());
  EXPECT_TRUE(QTest::qWaitFor([&] { return cutaway->height() > 150; }, patience));
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
    const QPoint border(context->geometry().center().x(), context->y() - 3);
    QTest::mousePress(&window, Qt::LeftButton, {}, border);
    QMouseEvent move(QEvent::MouseMove, border + QPoint(0, 60), window.mapToGlobal(border + QPoint(0, 60)),
                     Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &move);
    QCoreApplication::processEvents();  // the window moves a border from the event loop, and not after the release
    QTest::mouseRelease(&window, Qt::LeftButton, {}, border + QPoint(0, 60));
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

TEST_F(Window, Thorough_LightThemeIsRememberedAndLeavesPicturesAlone) {
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
