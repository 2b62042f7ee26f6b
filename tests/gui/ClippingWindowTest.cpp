// The crop box and clip planes: the panel, and handles dragged with the mouse on slices and in 3-D.

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/panels/ClippingPanel.h"

namespace fenestra::viewer::clippingWindowTest {
namespace {

using Kind = ClipTool::Handle::Kind;

class ClippingWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("clippingDock"));
    dock->show();
    dock->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return options().clipHandles(); }, patience));
  }
  ClippingPanel& clippingPanel() { return panel<ClippingPanel>(); }
  const Clipping& clipping() { return document().clipping(); }
  int steps() { return document().undoStack().count(); }
  void crop(glm::dvec3 low, glm::dvec3 high) {
    Clipping changed = clipping();
    changed.cropped = true;
    changed.box = {low, high};
    document().setClipping(changed, QStringLiteral("test"));
    waitUntilDrawn();
  }
  void choose(int action) {
    clippingPanel().addButton()->menu()->actions().at(action)->trigger();
    waitUntilDrawn();
  }
  template <class View>
  std::optional<ClipTool::Handle> handle(View* view, Kind kind, int which) {
    for (const ClipTool::Handle& each : view->clipTool().handles())
      if (each.kind == kind && each.which == which) return each;
    return {};
  }
  QPoint at(SliceView* view, const ClipTool::Handle& handle) { return view->widgetFromWorld(handle.at).toPoint(); }
  QPoint at(VolumeView* view, const ClipTool::Handle& handle) { return view->widgetFromWorld(handle.at)->toPoint(); }
  std::size_t pixelsThatDiffer(const QImage& a, const QImage& b) {
    std::size_t count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
    return count;
  }
};

TEST_F(ClippingWindow, Thorough_ThePanelCropsAndUndoBringsThePictureBackToTheBit) {
  options().setClipHandles(false);  // pictures alone
  waitUntilDrawn();
  const QImage before = picture(volume(0));
  const Look look = document().look();
  QTest::mouseClick(clippingPanel().crop(), Qt::LeftButton, {}, {8, clippingPanel().crop()->height() / 2});
  ASSERT_TRUE(clipping().cropped);
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), before) << "a box as large as the volume";
  EXPECT_NEAR(clipping().box.low.x, -48.0, 1e-9);
  EXPECT_NEAR(clipping().box.high.z, 48.0, 1e-9);
  QDoubleSpinBox* front = clippingPanel().end(1, 0);
  front->setFocus();
  front->selectAll();
  QTest::keyClicks(front, QLocale().toString(0.0, 'f', 1));
  QTest::keyClick(front, Qt::Key_Return);
  EXPECT_EQ(clipping().box.low.y, 0.0);
  waitUntilDrawn();
  EXPECT_GT(pixelsThatDiffer(picture(volume(0)), before), 1000u);
  EXPECT_EQ(steps(), 2);
  document().undoStack().undo();
  document().undoStack().undo();
  EXPECT_EQ(document().look(), look);
  EXPECT_FALSE(clippingPanel().crop()->isChecked());
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), before);
  document().undoStack().redo();
  document().undoStack().redo();
  EXPECT_EQ(clippingPanel().end(1, 0)->value(), 0.0);
}

TEST_F(ClippingWindow, AnEndCannotPassTheOther) {
  crop({-20, -20, -20}, {20, 20, 20});
  clippingPanel().end(0, 0)->setValue(100.0);
  EXPECT_EQ(clipping().box.low.x, 18.0) << "a voxel of 2 mm stays";
  EXPECT_EQ(clippingPanel().end(0, 0)->value(), 18.0);
  clippingPanel().end(2, 1)->setValue(-100.0);
  EXPECT_EQ(clipping().box.high.z, -18.0);
}

TEST_F(ClippingWindow, AFaceIsDraggedOnASlice) {
  crop({-30, -30, -30}, {30, 30, 30});
  SliceView* axial = slice(SlicePlane::Axial);
  EXPECT_FALSE(handle(axial, Kind::Face, 4)) << "faces along the slice have no handle";
  const auto left = handle(axial, Kind::Face, 1);
  ASSERT_TRUE(left);
  const QPoint from = at(axial, *left), to = from - QPoint(40, 0);
  const double moved = (axial->worldFromWidget(to) - axial->worldFromWidget(from)).x;
  const WindowLevel window = document().window();
  const int before = steps();
  drag(axial, from, to);
  EXPECT_NEAR(clipping().box.high.x, 30.0 + moved, 0.01);
  EXPECT_EQ(clipping().box.low, glm::dvec3(-30.0));
  EXPECT_EQ(document().window(), window) << "no drag of the window";
  EXPECT_EQ(steps(), before + 1) << "one step";
  document().undoStack().undo();
  EXPECT_EQ(clipping().box.high, glm::dvec3(30.0));
}

TEST_F(ClippingWindow, AFaceIsDraggedInThreeDimensions) {
  crop({-30, -30, -30}, {30, 30, 30});
  VolumeView* view = volume(0);
  const auto left = handle(view, Kind::Face, 1);
  ASSERT_TRUE(left);
  const Camera camera = cameras().camera(0);
  const QPoint from = at(view, *left);
  const QPointF there = *view->widgetFromWorld(left->at - glm::dvec3(20.0, 0.0, 0.0));
  const int before = steps();
  drag(view, from, there.toPoint());
  // The handle follows the mouse to a pixel; perspective makes the way a little uneven.
  EXPECT_NEAR(clipping().box.high.x, 10.0, 2.0);
  EXPECT_EQ(cameras().camera(0), camera) << "the view does not turn";
  EXPECT_EQ(steps(), before + 1);
  waitUntilDrawn();
  EXPECT_FALSE(green(view)) << "the marker lies outside";
}

TEST_F(ClippingWindow, PlanesAreAddedFlippedMovedAndRemoved) {
  cursor().moveTo({1.0, 1.0, 1.0});
  choose(2);  // from the coronal slice
  ASSERT_EQ(clipping().planes.size(), 1u);
  EXPECT_NEAR(clipping().planes[0].normal.y, 1.0, 1e-12);
  EXPECT_NEAR(clipping().planes[0].offset, 1.0, 1e-9);
  EXPECT_FALSE(green(volume(0))) << "the marker lies before it";
  QTest::mouseClick(clippingPanel().flipButton(), Qt::LeftButton);
  EXPECT_NEAR(clipping().planes[0].normal.y, -1.0, 1e-12);
  EXPECT_NEAR(clipping().planes[0].offset, -1.0, 1e-9);
  SliceView* axial = slice(SlicePlane::Axial);
  EXPECT_FALSE(handle(slice(SlicePlane::Coronal), Kind::Move, 0)) << "the plane is the slice";
  const auto square = handle(axial, Kind::Move, 0);
  ASSERT_TRUE(square);
  const QPoint from = at(axial, *square), to = from + QPoint(0, 30);
  const double moved = (axial->worldFromWidget(to) - axial->worldFromWidget(from)).y;
  drag(axial, from, to);
  EXPECT_NEAR(clipping().planes[0].offset, -1.0 - moved, 0.01);
  choose(3);  // facing C1
  choose(0);
  EXPECT_EQ(clipping().planes.size(), 3u);
  EXPECT_FALSE(clippingPanel().addButton()->isEnabled()) << "three are all";
  EXPECT_NEAR(glm::dot(clipping().planes[1].normal, cameras().camera(0).axes().forward), 1.0, 1e-12);
  clippingPanel().planes()->setCurrentRow(1);
  QTest::mouseClick(clippingPanel().removeButton(), Qt::LeftButton);
  ASSERT_EQ(clipping().planes.size(), 2u);
  EXPECT_NEAR(clipping().planes[1].normal.z, -1.0, 1e-12);
  QTest::mouseClick(clippingPanel().resetButton(), Qt::LeftButton);
  EXPECT_EQ(clipping(), Clipping());
}

TEST_F(ClippingWindow, UndoWhileAPlaneIsDraggedEndsTheDrag) {
  cursor().moveTo({1.0, 1.0, 1.0});
  choose(2);
  SliceView* axial = slice(SlicePlane::Axial);
  const auto square = handle(axial, Kind::Move, 0);
  ASSERT_TRUE(square);
  const QPoint from = at(axial, *square);
  const auto moveTo = [&](QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, axial->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(axial, &move);
  };
  QTest::mousePress(axial, Qt::LeftButton, Qt::NoModifier, from);
  moveTo(from + QPoint(0, 15));
  while (!clipping().planes.empty() && document().undoStack().canUndo()) document().undoStack().undo();
  ASSERT_TRUE(clipping().planes.empty());
  moveTo(from + QPoint(0, 30));
  QTest::mouseRelease(axial, Qt::LeftButton, Qt::NoModifier, from + QPoint(0, 30));
  EXPECT_TRUE(clipping().planes.empty());
}

TEST_F(ClippingWindow, APlaneIsTiltedAtItsArrow) {
  cursor().moveTo(glm::dvec3(0.0));
  choose(2);
  SliceView* axial = slice(SlicePlane::Axial);
  const auto ball = handle(axial, Kind::Tilt, 0);
  ASSERT_TRUE(ball);
  // From straight down the slice by its length to the patient's left.
  const QPoint from = at(axial, *ball);
  const QPointF foot = axial->widgetFromWorld(ball->foot);
  const double length = from.y() - foot.y();
  ASSERT_GT(length, 20.0);
  drag(axial, from, from + QPoint(static_cast<int>(length), 0));
  EXPECT_NEAR(clipping().planes[0].normal.x, std::sqrt(0.5), 0.03);
  EXPECT_NEAR(clipping().planes[0].normal.y, std::sqrt(0.5), 0.03);
  EXPECT_NEAR(clipping().planes[0].normal.z, 0.0, 1e-9);
  EXPECT_NEAR(clipping().planes[0].distance(ball->foot), 0.0, 1e-9) << "it turns about its foot";
  document().undoStack().undo();
  EXPECT_NEAR(clipping().planes[0].normal.y, 1.0, 1e-12);
}

TEST_F(ClippingWindow, HandlesShowWhileThePanelIsInSight) {
  EXPECT_TRUE(options().clipHandles());
  crop({-30, -30, -30}, {30, 30, 30});
  EXPECT_EQ(volume(0)->clipTool().handles().size(), 6u);
  window_->findChild<QDockWidget*>(QStringLiteral("cutawayDock"))->raise();
  EXPECT_TRUE(QTest::qWaitFor([&] { return volume(0)->clipTool().handles().empty(); }, patience));
  EXPECT_TRUE(slice(SlicePlane::Axial)->clipTool().handles().empty());
}

TEST_F(ClippingWindow, Thorough_ALabelIsExempt) {
  document().setFocus(std::monostate{});
  cursor().moveTo({1.0, 1.0, 1.0});
  choose(2);
  const QImage clipped = picture(volume(0));
  document().setExempt(marker, true);
  waitUntilDrawn();
  EXPECT_EQ(clipping().exempt, std::vector<std::uint16_t>{marker});
  EXPECT_GT(pixelsThatDiffer(picture(volume(0)), clipped), 100u);
  document().undoStack().undo();
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), clipped);
}

}  // namespace
}  // namespace fenestra::viewer::clippingWindowTest
