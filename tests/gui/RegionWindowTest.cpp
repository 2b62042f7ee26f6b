// The first minute without labels: data is opened, a structure clicked, the region corrected, all by mouse and keys.

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>

#include "io/VolumeWriter.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/LoadingBar.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/RegionPanel.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer::regionWindowTest {
namespace {

namespace fs = std::filesystem;

/// The marked ball without its labels, from a file.
class RegionWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (HasFatalFailure()) return;
    const fs::path file = tests::scratchFolder() / "ball.nii.gz";
    io::writeVolume(*markedBall().scene.volume, file);
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->open({file});
    ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
    waitUntilDrawn();
  }

  void clickSlice(glm::dvec3 world, Qt::KeyboardModifiers modifiers = {}) {
    cursor().moveTo(world);
    SliceView* axial = slice(SlicePlane::Axial);
    QTest::mouseClick(axial, Qt::LeftButton, modifiers, axial->widgetFromWorld(world).toPoint());
  }
  void waitUntilGrown() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
    waitUntilDrawn();
  }
  /// ml of the region in the focus.
  double size() {
    return document().growth()->curve.volume[static_cast<std::size_t>(document().regionStep())] / 1000.0;
  }
  RegionPanel& region() { return *panel<FocusPanel>().region(); }
};

TEST_F(RegionWindow, AClickPlacesTheCamerasOnTheStructure) {
  setAutomatic(true);
  const std::array<Camera, 2> before{cameras().camera(0), cameras().camera(1)};
  EXPECT_FALSE(region().isVisible());
  clickSlice(markerCentre);
  EXPECT_FALSE(document().isWhole()) << "the window goes on";
  waitUntilGrown();
  // A cube of seven voxels a side.
  EXPECT_NEAR(size(), 2.744, 0.5);
  EXPECT_TRUE(placement().measured());
  EXPECT_NE(cameras().camera(0), before[0]);
  EXPECT_NE(cameras().camera(1), before[1]);
  EXPECT_TRUE(region().isVisible());
  EXPECT_TRUE(region().automatic()->isChecked());
  EXPECT_EQ(region().slider()->value(), document().regionStep());

  // Its tolerance and further seeds refine the region that the cameras look at, so that the cameras stay.
  const Camera placed = cameras().camera(0);
  wheel(slice(SlicePlane::Axial), 3, Qt::AltModifier);
  waitUntilDrawn();
  QTest::qWait(400);  // longer than the pause before a focus is placed
  EXPECT_FALSE(placement().isBusy());
  EXPECT_EQ(cameras().camera(0), placed);
}

TEST_F(RegionWindow, AClickIn3DGrowsWhatIsSeenThere) {
  const std::optional<QPointF> at = volume(0)->widgetFromWorld({0.0, -44.0, 0.0});
  ASSERT_TRUE(at);
  QTest::mouseClick(volume(0), Qt::LeftButton, {}, at->toPoint());
  ASSERT_TRUE(document().region());
  EXPECT_LT(glm::distance(cursor().position(), glm::dvec3(0.0, -42.0, 0.0)), 3.5);
  waitUntilGrown();
  EXPECT_NEAR(size(), 4.0 / 3.0 * 3.1416 * 44.0 * 44.0 * 44.0 / 1000.0, 40.0);  // a voxel of its surface is 48 ml

  QTest::keyClick(window_.get(), Qt::Key_G);
  document().setFocus(std::monostate{});
  waitUntilDrawn();
  QTest::mouseClick(volume(0), Qt::LeftButton, {}, at->toPoint());
  EXPECT_FALSE(document().region()) << "without the tool a click is the crosshair's";
}

TEST_F(RegionWindow, WheelSliderPlotAndKeysChangeTheTolerance) {
  clickSlice(markerCentre);
  waitUntilGrown();
  const int steps = document().undoStack().count(), first = document().regionStep();
  const int slices = slice(SlicePlane::Axial)->slice();
  wheel(slice(SlicePlane::Axial), 1, Qt::AltModifier);
  wheel(slice(SlicePlane::Axial), 1, Qt::AltModifier);
  wheel(volume(1), -1, Qt::AltModifier);
  EXPECT_EQ(document().regionStep(), first + 4);
  EXPECT_EQ(slice(SlicePlane::Axial)->slice(), slices);
  EXPECT_FALSE(region().automatic()->isChecked());
  QTest::keyClick(window_.get(), Qt::Key_Period);
  QTest::keyClick(window_.get(), Qt::Key_Comma);
  QTest::keyClick(window_.get(), Qt::Key_Comma);
  EXPECT_EQ(document().regionStep(), first + 3);
  while (document().undoStack().count() > steps && document().undoStack().canUndo() &&
         document().undoStack().index() > steps)
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().regionStep(), first);
  EXPECT_TRUE(region().automatic()->isChecked());

  // A number typed, and its undo.
  region().tolerance()->setFocus();
  region().tolerance()->selectAll();
  QTest::keyClicks(region().tolerance(), QStringLiteral("123.4"));
  QTest::keyClick(region().tolerance(), Qt::Key_Return);
  EXPECT_EQ(document().region()->tolerance, 123.4);
  document().undoStack().undo();
  EXPECT_FALSE(document().region()->tolerance);
  EXPECT_EQ(region().slider()->value(), first);

  // A press in the plot on the last step: everything.
  TolerancePlot* plot = region().plot();
  const double before = size();
  drag(plot, QPoint(static_cast<int>(plot->xOf(200)), 20), QPoint(static_cast<int>(plot->xOf(250)), 20));
  EXPECT_GT(size(), 5.0 * before);
  EXPECT_EQ(document().undoStack().count(), steps + 1) << "a drag is one step";
}

TEST_F(RegionWindow, ShiftAndCtrlClicksAddAndTakeAway) {
  const glm::dvec3 inBody(-10.0, 10.0, 17.0);
  clickSlice(markerCentre);
  waitUntilGrown();
  const double one = size();
  clickSlice(inBody, Qt::ShiftModifier);
  EXPECT_EQ(document().region()->inside.size(), 2u);
  waitUntilGrown();
  const double both = size();
  EXPECT_GT(both, 100.0) << "the ball too";
  const QImage marked = picture(slice(SlicePlane::Axial));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().isWhole()) << "what was grown before is still there";
  EXPECT_EQ(size(), one);
  EXPECT_NE(picture(slice(SlicePlane::Axial)), marked);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(size(), both);
  waitUntilDrawn();
  EXPECT_EQ(picture(slice(SlicePlane::Axial)), marked) << "to the bit";

  document().undoStack().undo();
  document().setTolerance(900.0);  // from the marker's 900 HU down to the ball's 40
  EXPECT_GT(size(), 100.0) << "a leak into the ball";
  clickSlice(inBody, Qt::ControlModifier);
  EXPECT_EQ(document().region()->outside.size(), 1u);
  waitUntilGrown();
  EXPECT_LT(size(), 10.0);
}

TEST_F(RegionWindow, IsPaintedOnSlicesInOneStepAStroke) {
  FocusPanel& focus = panel<FocusPanel>();
  EXPECT_FALSE(focus.paintRadius()->isVisible());
  QTest::mouseClick(focus.paint(), Qt::LeftButton);
  EXPECT_TRUE(focus.paintRadius()->isVisible() && focus.paintSoftness()->isVisible());
  focus.paintRadius()->box()->setValue(6.0);
  cursor().moveTo(glm::dvec3(0.0));
  SliceView* axial = slice(SlicePlane::Axial);
  const auto at = [&](glm::dvec3 world) { return axial->widgetFromWorld(world).toPoint(); };
  const int steps = document().undoStack().index();
  const WindowLevel window = document().window();
  drag(axial, at({-15.0, 0.0, 0.0}), at({15.0, 0.0, 0.0}));
  EXPECT_EQ(document().window(), window) << "the drag paints";
  ASSERT_TRUE(document().region());
  EXPECT_TRUE(document().region()->inside.empty());
  EXPECT_EQ(document().undoStack().index(), steps + 1);
  waitUntilGrown();
  // A cylinder between half balls, in voxels of 2 mm; a voxel on the rim counts as a whole or not at all.
  const double whole = (3.1416 * 36.0 * 30.0 + 4.0 / 3.0 * 3.1416 * 216.0) / 1000.0;
  EXPECT_NEAR(size(), whole, 0.3 * whole);
  const double line = size();
  const QImage painted = picture(axial);
  QTest::mouseClick(axial, Qt::LeftButton, Qt::ShiftModifier, at({0.0, 0.0, 0.0}));
  waitUntilGrown();
  EXPECT_LT(size(), 0.85 * line);
  EXPECT_GT(size(), 0.3 * line);
  document().undoStack().undo();
  waitUntilDrawn();
  EXPECT_EQ(size(), line);
  EXPECT_EQ(picture(axial), painted) << "to the bit";
  // It is a region as any other: a seed makes it grow, and it is kept as a label.
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(focus.paint()->isChecked());
  clickSlice(markerCentre, Qt::ShiftModifier);
  waitUntilGrown();
  EXPECT_EQ(document().region()->painted.size(), 1u);
  EXPECT_GT(size(), line + 2.0) << "the marker, of 2.7 ml, too";
  region().name()->setText(QStringLiteral("painted"));
  QTest::mouseClick(region().keep(), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().labels() != nullptr; }, patience));
  EXPECT_EQ(document().labels()->labels.back().name, "painted");
}

TEST_F(RegionWindow, IsPaintedIn3DOnWhatIsSeen) {
  QTest::mouseClick(panel<FocusPanel>().paint(), Qt::LeftButton);
  const std::optional<QPointF> at = volume(0)->widgetFromWorld({0.0, -44.0, 0.0});
  ASSERT_TRUE(at);
  const Camera before = cameras().camera(0);
  drag(volume(0), at->toPoint(), at->toPoint() + QPoint(25, 0));
  EXPECT_EQ(cameras().camera(0), before) << "the drag paints";
  ASSERT_TRUE(document().region());
  const std::vector<SelectionStroke>& painted = document().region()->painted;
  ASSERT_EQ(painted.size(), 1u);
  EXPECT_GT(painted.front().anchors.size(), 1u);
  // The stroke lies on what is seen: the ball of 44 mm, in voxels of 2 mm.
  for (const glm::dvec3 anchor : painted.front().anchors) EXPECT_NEAR(glm::length(anchor), 43.0, 4.0);
  waitUntilGrown();
  EXPECT_GT(size(), 2.0);
  drag(volume(0), at->toPoint(), at->toPoint() + QPoint(25, 0), Qt::LeftButton, Qt::ControlModifier);
  EXPECT_NE(cameras().camera(0), before) << "Ctrl+drag turns";
}

TEST_F(RegionWindow, APaintedSelectionIsGhostedAndComesBackToTheBit) {
  Look look = document().look();
  look.method.kind = kindOf<methods::Selection>;
  document().edit(QStringLiteral("method"), std::move(look));
  panel<FocusPanel>().paint()->click();
  SelectionBrush& brush = window_->workspace().selection;
  const auto views = [&] {  // without the tool's ring
    brush.setActive(false);
    waitUntilDrawn();
    std::array<QImage, 3> all{picture(volume(0)), picture(volume(1)), picture(slice(SlicePlane::Axial))};
    brush.setActive(true);
    return all;
  };
  const QPoint front = volume(0)->widgetFromWorld({0.0, -44.0, 0.0})->toPoint();
  const auto nothing = views();
  drag(volume(0), front - QPoint(15, 0), front + QPoint(15, 0));
  waitUntilGrown();
  const auto painted = views();
  const double size = this->size();
  EXPECT_NE(painted[0], nothing[0]);
  drag(volume(0), front - QPoint(15, 30), front + QPoint(15, -30));
  waitUntilGrown();
  EXPECT_GT(this->size(), size);
  QTest::mouseClick(volume(0), Qt::LeftButton, Qt::ShiftModifier, front);
  waitUntilGrown();
  ASSERT_EQ(document().region()->painted.size(), 3u);
  EXPECT_FALSE(document().region()->painted.back().adds);
  document().undoStack().undo();
  document().undoStack().undo();
  waitUntilGrown();
  EXPECT_EQ(views(), painted) << "to the bit";
  document().undoStack().undo();
  EXPECT_FALSE(document().region());
  EXPECT_EQ(views(), nothing) << "to the bit";
}

TEST_F(RegionWindow, PaintingTakesTurnsWithTheOtherTools) {
  SelectionBrush& painting = window_->workspace().selection;
  QToolButton* button = panel<FocusPanel>().paint();
  button->click();
  ASSERT_TRUE(painting.isActive());
  brush().setActive(true);
  EXPECT_FALSE(painting.isActive());
  button->click();
  EXPECT_FALSE(brush().isActive());
  Look look = document().look();
  look.method.kind = kindOf<methods::Sculpt>;
  document().edit(QStringLiteral("method"), std::move(look));
  Carving& carving = window_->workspace().carving;
  carving.setActive(true);
  ASSERT_TRUE(carving.isActive());
  EXPECT_FALSE(painting.isActive());
  button->click();
  EXPECT_FALSE(carving.isActive());
}

/// A stroke that would leave no region is undone, with a message.
TEST_F(RegionWindow, ErasingAllIsRefused) {
  document().paintSelection({{glm::dvec3(0.0)}, 9.0});
  waitUntilGrown();
  const double before = size();
  EXPECT_GT(before, 1.0);
  document().paintSelection({{glm::dvec3(0.0)}, 20.0, 0.0, false});
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  EXPECT_EQ(document().region()->painted.size(), 1u);
  EXPECT_EQ(size(), before);
  EXPECT_FALSE(window_->notices().texts().isEmpty());
  document().setFocus({});
  document().paintSelection({{glm::dvec3(0.0)}, 20.0, 0.0, false});
  EXPECT_FALSE(document().region()) << "there is nothing to take from";
}

TEST_F(RegionWindow, AShiftDragDrawsTheBallThatBoundsARegion) {
  const glm::dvec3 inBody(-10.0, 10.0, 17.0);
  cursor().moveTo(inBody);
  waitUntilDrawn();
  SliceView* axial = slice(SlicePlane::Axial);
  const std::array<QImage, 2> before{picture(volume(0)), picture(slice(SlicePlane::Coronal))};
  const QPoint from = axial->widgetFromWorld(inBody).toPoint();
  const QPoint to = axial->widgetFromWorld(inBody + glm::dvec3(15.0, 0.0, 0.0)).toPoint();
  const WindowLevel window = document().window();
  QTest::mousePress(axial, Qt::LeftButton, Qt::ShiftModifier, from);
  QMouseEvent move(QEvent::MouseMove, to, axial->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, Qt::ShiftModifier);
  QApplication::sendEvent(axial, &move);
  ASSERT_TRUE(window_->workspace().ball.ball());
  EXPECT_NEAR(window_->workspace().ball.ball()->radius, 15.0, 1.0);
  EXPECT_NE(picture(volume(0)), before[0]) << "its ring shows in all views";
  EXPECT_NE(picture(slice(SlicePlane::Coronal)), before[1]);
  QTest::mouseRelease(axial, Qt::LeftButton, Qt::ShiftModifier, to);
  EXPECT_FALSE(window_->workspace().ball.ball());
  EXPECT_EQ(document().window(), window);
  ASSERT_TRUE(document().region());
  EXPECT_NEAR(document().region()->ball, 15.0, 1.0);
  waitUntilGrown();
  EXPECT_LT(size(), 1.1 * 4.0 / 3.0 * 3.1416 * 15.0 * 15.0 * 15.0 / 1000.0);
  EXPECT_TRUE(region().ball()->isVisible());
  region().ball()->setValue(10.0);
  waitUntilGrown();
  EXPECT_EQ(document().region()->ball, 10.0);
  QTest::mouseClick(region().noBall(), Qt::LeftButton);
  EXPECT_EQ(document().region()->ball, 0.0);
  waitUntilGrown();
  EXPECT_FALSE(region().ball()->isVisible());

  // In 3-D, where the plain drag turns.
  const Camera camera = cameras().camera(0);
  const QPoint front = volume(0)->widgetFromWorld({0.0, -44.0, 0.0})->toPoint();
  drag(volume(0), front, front + QPoint(40, 0), Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_EQ(cameras().camera(0), camera);
  EXPECT_GT(document().region()->ball, 1.0);
  waitUntilGrown();
  // Without the tool it is the view's drag.
  options().setGrows(false);
  const RegionFocus drawn = *document().region();
  drag(volume(0), front, front + QPoint(40, 0), Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_NE(cameras().camera(0), camera);
  EXPECT_EQ(*document().region(), drawn);
}

TEST_F(RegionWindow, ALargeRegionAsksAndTheFocusBeforeShows) {
  document().setFocus(ValueFocus{.values = {800.0, 1000.0}});
  waitUntilDrawn();
  const Scene before = document().scene();
  clickSlice({-10.0, 10.0, 17.0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  ASSERT_TRUE(document().asksToOpen()) << "the ball is the body";
  EXPECT_EQ(document().scene(), before);
  EXPECT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(region().open()->isVisible());
  EXPECT_TRUE(region().facts()->text().contains(QLatin1String("of the body")));
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(document().focus()));
  EXPECT_TRUE(window_->notices().texts().isEmpty());

  clickSlice({-10.0, 10.0, 17.0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().asksToOpen(); }, patience));
  QTest::mouseClick(region().open(), Qt::LeftButton);
  EXPECT_FALSE(document().asksToOpen());
  EXPECT_FALSE(region().open()->isVisible());
  EXPECT_TRUE(window_->notices().texts().isEmpty());
  EXPECT_NE(document().scene(), before);
}

TEST_F(RegionWindow, ADoubtfulRegionAsksAndEnterOpensToIt) {
  clickSlice(markerCentre);
  waitUntilGrown();
  EXPECT_FALSE(document().asksToOpen());
  // The marker as it were with a border that lies in the noise.
  const auto weak = std::make_shared<segmentation::Growth>(*document().growth());
  std::ranges::fill(weak->curve.contrast, 0.5);
  const auto facts = std::make_shared<const segmentation::GrowthFacts>(*document().scene().volume, *weak);
  const auto clickDoubtful = [&](double beside) {
    document().setFocus(ValueFocus{.values = {800.0, 1000.0}});
    waitUntilDrawn();
    clickSlice(markerCentre + glm::dvec3(beside, 0.0, 0.0));
    document().setGrowth(*document().region(), {weak, facts});
  };
  clickDoubtful(2.0);
  const Scene before = document().scene();
  ASSERT_EQ(document().doubt(), Document::Doubt::Border);
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(before.look.focus)) << "the 3-D views wait";
  EXPECT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(region().open()->isVisible());
  EXPECT_TRUE(region().facts()->text().contains(QLatin1String("doubtful")));
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(document().focus()));
  EXPECT_TRUE(window_->notices().texts().isEmpty());

  for (QWidget* view : {static_cast<QWidget*>(slice(SlicePlane::Axial)), static_cast<QWidget*>(volume(0))}) {
    clickDoubtful(view == volume(0) ? 4.0 : 3.0);
    ASSERT_TRUE(document().asksToOpen());
    QTest::keyClick(view, Qt::Key_Return);
    EXPECT_TRUE(document().showsGrowth());
    EXPECT_FALSE(region().open()->isVisible());
    EXPECT_TRUE(window_->notices().texts().isEmpty());
  }
  // A tolerance of the user's own needs no question.
  clickDoubtful(1.0);
  ASSERT_TRUE(document().asksToOpen());
  wheel(slice(SlicePlane::Axial), 1, Qt::AltModifier);
  EXPECT_TRUE(document().showsGrowth());
}

TEST_F(RegionWindow, SlicesKeepTheFocusBeforeUntilTheRegionIsWhole) {
  QTest::keyClick(window_.get(), Qt::Key_C);
  cursor().moveTo(markerCentre);
  document().setFocus(ValueFocus{.values = {800.0, 1000.0}});
  waitUntilDrawn();
  options().setText(false);
  const auto focusOf = [&](SliceView* view) {
    QImage image(view->size(), QImage::Format_RGB32);
    QPainter painter(&image);
    view->draw(painter, false);
    return image;
  };
  const QImage before = focusOf(slice(SlicePlane::Coronal));
  clickSlice(markerCentre);
  ASSERT_TRUE(document().awaitsGrowth());
  ASSERT_FALSE(document().growth());
  EXPECT_EQ(focusOf(slice(SlicePlane::Coronal)), before);
  waitUntilGrown();
  EXPECT_NE(focusOf(slice(SlicePlane::Coronal)), before);
  EXPECT_TRUE(region().facts()->text().startsWith(QLatin1String("Values: "))) << region().facts()->text().toStdString();
}

TEST_F(RegionWindow, EscapeTakesAGrowingRegionBack) {
  const QImage before = picture(slice(SlicePlane::Axial));
  cursor().moveTo(markerCentre);
  const QImage atMarker = picture(slice(SlicePlane::Axial));
  EXPECT_NE(atMarker, before);
  clickSlice(markerCentre);
  ASSERT_TRUE(document().awaitsGrowth());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(document().region());
  waitUntilDrawn();
  EXPECT_FALSE(document().undoStack().canUndo());
  EXPECT_TRUE(window_->notices().texts().isEmpty()) << window_->notices().texts().join(QLatin1Char('|')).toStdString();
}

TEST_F(RegionWindow, TheCancelButtonTakesAWaitingRegionBack) {
  const auto focusAt = [&](glm::dvec3 world) {
    RegionFocus region;
    region.inside = {world};
    document().setFocus(region);
  };
  focusAt(markerCentre);
  focusAt(glm::dvec3(0.0));  // waits for the first one's job to stop
  ASSERT_TRUE(document().awaitsGrowth());
  QPushButton* cancel = nullptr;
  for (LoadingBar* bar : window_->statusBar()->findChildren<LoadingBar*>())
    if (bar->isVisible()) cancel = bar->findChild<QPushButton*>();
  ASSERT_NE(cancel, nullptr);
  QTest::mouseClick(cancel, Qt::LeftButton);
  waitUntilDrawn();
  const RegionFocus* region = document().region();
  EXPECT_TRUE(!region || region->inside.front() == markerCentre) << "the waiting region is taken back, as by Escape";
}

TEST_F(RegionWindow, ADoubleClickLeavesNoRegion) {
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint at = axial->widgetFromWorld(markerCentre).toPoint();
  QTest::mouseClick(axial, Qt::LeftButton, {}, at);
  QTest::mouseDClick(axial, Qt::LeftButton, {}, at);
  EXPECT_TRUE(views().isMaximised());
  EXPECT_FALSE(document().region());
  waitUntilDrawn();
  EXPECT_FALSE(document().undoStack().canUndo());
}

/// The Visible Human's head, as it comes: 245 DICOM files of 512×512.
TEST_F(RegionWindow, GrowsASinusOfARealHead) {
  const fs::path head = tests::unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head");
  if (head.empty()) GTEST_SKIP() << "needs the test-data file visible-human/VHMCT1mm_Head.tar.xz";
  drop({head});
  if (HasFatalFailure()) return;
  setAutomatic(true);
  const glm::dvec3 sinus(231.5, 187.1, 1122.0);  // the right maxillary one
  clickSlice(sinus);
  EXPECT_TRUE(QTest::qWaitFor([&] { return document().growth() != nullptr; }, patience));
  EXPECT_TRUE(document().awaitsGrowth()) << "a first part comes before the whole";
  waitUntilGrown();
  if (HasFatalFailure()) return;
  EXPECT_GT(size(), 10.0);
  EXPECT_LT(size(), 35.0);  // adults' hold about 10 to 25 ml
  EXPECT_TRUE(placement().measured());
}

}  // namespace
}  // namespace fenestra::viewer::regionWindowTest
