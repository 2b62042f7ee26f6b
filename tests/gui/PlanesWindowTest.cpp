// Slices that are turned, that face a camera, and that are thick, by mouse and keys.

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QTest>

#include <glm/gtc/constants.hpp>

#include "tests/gui/WindowFixture.h"
#include "viewer/actions/PlaneMenu.h"
#include "viewer/files/Sessions.h"

namespace fenestra::viewer::planesWindowTest {
namespace {

constexpr double degree = glm::pi<double>() / 180.0;

class PlanesWindow : public Window {
 protected:
  SlicePlanes& planes() { return window_->workspace().planes; }
  SliceView* axial() { return slice(SlicePlane::Axial); }
  SliceView* coronal() { return slice(SlicePlane::Coronal); }

  void hover(QWidget* view, QPoint at) {
    QMouseEvent event(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(view, &event);
  }
  /// The first handle of a plane's line in a view.
  QPointF handle(SliceView* view, SlicePlane plane) {
    for (const PlaneTool::Handle& each : view->planeTool().handles())
      if (each.plane == plane) return each.at;
    ADD_FAILURE() << "no handle";
    return {};
  }
  /// Drags a handle clockwise about the crosshair by an angle in degrees, as far as whole pixels allow.
  void turn(SliceView* view, SlicePlane plane, double degrees, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF centre = view->widgetFromWorld(cursor().position()), from = handle(view, plane);
    const QPointF to = centre + QTransform().rotate(degrees).map(from - centre);
    drag(view, from.toPoint(), to.toPoint(), Qt::LeftButton, modifiers);
  }
  /// Grey of a slice's picture where a world point shows, 0…255, without marks and tints.
  int grey(SliceView* view, glm::dvec3 world) {
    options().setLabels(false);
    QImage image(view->size(), QImage::Format_RGB32);
    QPainter painter(&image);
    view->draw(painter, false);
    return qRed(image.pixel(view->widgetFromWorld(world).toPoint()));
  }
  /// Grey of a value under the window, 0…255.
  double greyOf(double value) {
    const WindowLevel window = document().window();
    return std::clamp((value - window.level) / window.width + 0.5, 0.0, 1.0) * 255.0;
  }
};

TEST_F(PlanesWindow, AHandleTurnsAnotherPlaneAboutThisSlicesNormal) {
  cursor().moveTo({4.0, -6.0, 8.0});
  const int steps = document().undoStack().count();
  const WindowLevel window = document().window();
  turn(axial(), SlicePlane::Coronal, 30.0);
  ASSERT_TRUE(planes().isTurned(SlicePlane::Coronal));
  EXPECT_FALSE(planes().isTurned(SlicePlane::Axial));
  EXPECT_FALSE(planes().isTurned(SlicePlane::Sagittal));
  // Clockwise in a picture of the patient from below is from L towards P. A pixel at 100 of the axis is 0.6°.
  const PlaneAxes axes = planes().axes(SlicePlane::Coronal);
  EXPECT_LT(glm::distance(axes.right, {std::cos(30 * degree), std::sin(30 * degree), 0.0}), 1.5 * degree);
  EXPECT_EQ(axes.down, glm::dvec3(0, 0, -1));
  EXPECT_NEAR(axial()->planeTool().angle(SlicePlane::Coronal), 30.0, 1.5);
  EXPECT_NEAR(planes().tilt(SlicePlane::Coronal).degrees, 30.0, 1.5);
  EXPECT_EQ(cursor().position(), glm::dvec3(4.0, -6.0, 8.0)) << "the crosshair stays";
  EXPECT_EQ(document().undoStack().count(), steps) << "a view's state is no step";
  EXPECT_EQ(document().window(), window) << "nor is the drag one of the window";
  EXPECT_FALSE(planes().isMoving(SlicePlane::Coronal));
}

TEST_F(PlanesWindow, LinesAreWhereThePlanesCutEachOtherHoweverTheyAreTurned) {
  // Beside the middle of a voxel, so that the volume's own slices miss the crosshair.
  cursor().moveTo({3.3, -5.4, 6.7});
  turn(axial(), SlicePlane::Coronal, 25.0);
  turn(slice(SlicePlane::Sagittal), SlicePlane::Coronal, -20.0);
  turn(coronal(), SlicePlane::Axial, 35.0);
  const glm::dvec3 normal = glm::abs(planes().axes(SlicePlane::Coronal).normal);
  EXPECT_GT(std::min({normal.x, normal.y, normal.z}), 0.1) << "double-oblique";
  for (SliceView* view : views().sliceViews()) {
    const std::vector<PlaneCut> cuts = view->planeTool().cuts();
    EXPECT_EQ(cuts.size(), 2u);
    for (const PlaneCut& cut : cuts)
      for (const double way : {-80.0, 0.0, 55.0}) {
        const glm::dvec3 world = view->worldFromWidget(cut.at + way * cut.along);
        const glm::dvec3 other = planes().axes(cut.plane).normal;
        EXPECT_NEAR(glm::dot(world - cursor().position(), other), 0.0, 1e-6);
      }
  }
}

TEST_F(PlanesWindow, ATurnedSliceShowsTheVolumeWhereItSaysThatItDoes) {
  cursor().moveTo(markerCentre);
  turn(axial(), SlicePlane::Coronal, 33.0);
  turn(slice(SlicePlane::Sagittal), SlicePlane::Coronal, 21.0);
  const Volume& volume = *document().scene().volume;
  int seen = 0;
  for (int y = 20; y < coronal()->height() - 20; y += 13)
    for (int x = 20; x < coronal()->width() - 20; x += 13) {
      const glm::dvec3 world = coronal()->worldFromWidget({x + 0.5, y + 0.5});
      const glm::dvec3 index(volume.grid.indexFromWorld() * glm::dvec4(world, 1.0));
      // Beside edges, where half a pixel matters.
      const auto at = [&](glm::dvec3 offset) { return volume.sample(index + offset); };
      if (glm::any(glm::lessThan(index, glm::dvec3(2.0))) || glm::any(glm::greaterThan(index, glm::dvec3(45.0))))
        continue;
      bool even = true;
      for (const double step : {-1.5, 1.5})
        for (const glm::dvec3 way : {glm::dvec3(step, 0, 0), glm::dvec3(0, step, 0), glm::dvec3(0, 0, step)})
          even = even && at(way) == at({});
      if (!even) continue;
      ++seen;
      EXPECT_NEAR(grey(coronal(), world), greyOf(at({})), 1.0) << "x " << x << ", y " << y;
    }
  EXPECT_GT(seen, 40);
  EXPECT_NEAR(grey(coronal(), markerCentre), 255, 0.0);
}

TEST_F(PlanesWindow, ThePictureStaysAroundTheCrosshairWhileItsPlaneTurns) {
  cursor().moveTo(markerCentre);
  const QPointF before = coronal()->widgetFromWorld(markerCentre);
  const QPointF farther = coronal()->widgetFromWorld(markerCentre + glm::dvec3(0, 0, 10));
  turn(axial(), SlicePlane::Coronal, 40.0);
  const QPointF after = coronal()->widgetFromWorld(markerCentre);
  EXPECT_LT(QLineF(before, after).length(), 1e-6);
  EXPECT_LT(QLineF(farther, coronal()->widgetFromWorld(markerCentre + glm::dvec3(0, 0, 10))).length(), 1e-6)
      << "nor does its scale change";
  cursor().step(coronal()->sliceGeometry(), 3);
  EXPECT_LT(QLineF(after, coronal()->widgetFromWorld(cursor().position())).length(), 1e-6);
  options().setLabels(true);
  // The green square is where the marker is; in focus its tint is strong enough to be told from white.
  document().focusOn(marker);
  cursor().moveTo(markerCentre);
  const std::optional<QPointF> green = this->green(coronal());
  ASSERT_TRUE(green);
  EXPECT_NEAR(green->x(), 2.0 * after.x() / coronal()->width() - 1.0, 0.05);
  EXPECT_NEAR(green->y(), 2.0 * after.y() / coronal()->height() - 1.0, 0.05);
}

TEST_F(PlanesWindow, WheelAndArrowsStepAlongThePlanesOwnNormal) {
  cursor().moveTo({2.0, 3.0, 4.0});
  turn(axial(), SlicePlane::Coronal, 30.0);
  const glm::dvec3 normal = planes().axes(SlicePlane::Coronal).normal;
  const double step = voxelLength(document().scene().volume->grid, normal);
  const auto expectStep = [&](const std::function<void()>& act, int slices) {
    const glm::dvec3 from = cursor().position();
    const int before = coronal()->slice();
    act();
    EXPECT_EQ(coronal()->slice(), before + slices);
    EXPECT_LT(glm::distance(cursor().position() - from, slices * step * normal), 1e-9);
  };
  expectStep([&] { wheel(coronal(), 2); }, 2);
  expectStep([&] { wheel(coronal(), -1); }, -1);
  expectStep([&] { QTest::keyClick(coronal(), Qt::Key_Up); }, 1);
  expectStep([&] { QTest::keyClick(coronal(), Qt::Key_Left); }, -1);
  expectStep([&] { QTest::keyClick(coronal(), Qt::Key_PageUp); }, 10);
}

TEST_F(PlanesWindow, ShiftHoldsALineToTheDiagonalsAndCtrlTurnsBoth) {
  turn(axial(), SlicePlane::Coronal, 37.0, Qt::ShiftModifier);
  EXPECT_NEAR(axial()->planeTool().angle(SlicePlane::Coronal), 45.0, 1e-9);
  turn(axial(), SlicePlane::Coronal, -40.0, Qt::ShiftModifier);
  EXPECT_NEAR(axial()->planeTool().angle(SlicePlane::Coronal), 0.0, 1e-9);
  planes().resetAll();
  turn(axial(), SlicePlane::Sagittal, 20.0, Qt::ControlModifier);
  EXPECT_NEAR(axial()->planeTool().angle(SlicePlane::Coronal), 20.0, 1.5);
  EXPECT_NEAR(axial()->planeTool().angle(SlicePlane::Sagittal), axial()->planeTool().angle(SlicePlane::Coronal), 1e-9);
}

TEST_F(PlanesWindow, APressOnAHandleWithoutADragIsAClick) {
  const QPointF at = handle(axial(), SlicePlane::Coronal);
  const glm::dvec3 world = axial()->worldFromWidget(at.toPoint());
  hover(axial(), at.toPoint());
  EXPECT_EQ(axial()->cursor().shape(), Qt::OpenHandCursor);
  QTest::mouseClick(axial(), Qt::LeftButton, {}, at.toPoint());
  EXPECT_LT(glm::distance(cursor().position(), world), 1e-6);
  EXPECT_FALSE(planes().isTurned(SlicePlane::Coronal));
}

TEST_F(PlanesWindow, HandlesGoWithTheCrosshair) {
  EXPECT_EQ(axial()->planeTool().handles().size(), 4u);
  options().setCrosshair(false);
  EXPECT_TRUE(axial()->planeTool().handles().empty());
  options().setCrosshair(true);
  brush().toggle(false);
  EXPECT_TRUE(axial()->planeTool().handles().empty()) << "while a brush has the mouse";
}

TEST_F(PlanesWindow, AMeasureOnATurnedSliceShowsOnItsPlaneAlone) {
  cursor().moveTo(markerCentre);
  turn(axial(), SlicePlane::Coronal, 30.0);
  const glm::dvec3 down = planes().axes(SlicePlane::Coronal).down, right = planes().axes(SlicePlane::Coronal).right;
  QTest::keyClick(coronal(), Qt::Key_D);
  const QPoint from = coronal()->widgetFromWorld(markerCentre - 15.0 * right + 12.0 * down).toPoint();
  const QPoint to = coronal()->widgetFromWorld(markerCentre + 15.0 * right + 12.0 * down).toPoint();
  drag(coronal(), from, to);
  QTest::keyClick(coronal(), Qt::Key_Escape);
  ASSERT_EQ(document().measures().size(), 1u);
  // The ends stand on whole pixels of at most 0.4 mm.
  EXPECT_NEAR(document().measured(0).length.value(), 30.0, 1.0);
  const QPoint middle = (from + to) / 2;
  EXPECT_TRUE(coronal()->measureTool().measureAt(middle));
  wheel(coronal(), 1);
  EXPECT_FALSE(coronal()->measureTool().measureAt(middle)) << "another slice";
  wheel(coronal(), -1);
  EXPECT_TRUE(coronal()->measureTool().measureAt(middle));
  planes().reset(SlicePlane::Coronal);
  EXPECT_FALSE(coronal()->measureTool().measureAt(middle)) << "another plane";

  // A region on a turned plane has the values there.
  turn(axial(), SlicePlane::Coronal, 30.0);
  QTest::keyClick(coronal(), Qt::Key_Q);
  drag(coronal(), coronal()->widgetFromWorld(markerCentre - 3.0 * right - 3.0 * down).toPoint(),
       coronal()->widgetFromWorld(markerCentre + 3.0 * right + 3.0 * down).toPoint());
  QTest::keyClick(coronal(), Qt::Key_Escape);
  ASSERT_EQ(document().measures().size(), 2u);
  ASSERT_TRUE(document().measured(1).region);
  EXPECT_EQ(document().measured(1).region->mean, 900.0);
  EXPECT_GE(document().measured(1).region->count, 4u) << "28 mm² in pixels of 2.3 × 2.3 mm, from a corner on";
}

TEST_F(PlanesWindow, ASliceFacesACameraWhileItTurns) {
  cursor().moveTo(markerCentre);
  axial()->setFocus();
  QTest::keyClick(axial(), Qt::Key_F, Qt::ShiftModifier);
  EXPECT_EQ(planes().pose(SlicePlane::Axial).follow, PlaneFollow::C1);
  drag(volume(0), {200, 150}, {260, 190});
  const Camera::Axes camera = cameras().camera(0).axes();
  const SliceGeometry& geometry = axial()->sliceGeometry();
  EXPECT_LT(glm::distance(glm::normalize(geometry.right), camera.right), 1e-9);
  EXPECT_LT(glm::distance(glm::normalize(geometry.down), -camera.up), 1e-9);
  EXPECT_NEAR(geometry.pixelFromWorld(markerCentre).z, axial()->slice(), 1e-9) << "through the crosshair";
  waitUntilDrawn();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !planes().isMoving(SlicePlane::Axial); }, patience));
  EXPECT_EQ(gradeOf(axial()->fidelity()), Fidelity::Faithful) << "at rest";
  QTest::keyClick(axial(), Qt::Key_F, Qt::ShiftModifier);
  EXPECT_EQ(planes().pose(SlicePlane::Axial).follow, PlaneFollow::None);
  QTest::keyClick(axial(), Qt::Key_V);
  EXPECT_FALSE(planes().isTurned(SlicePlane::Axial));
}

TEST_F(PlanesWindow, ASlabShowsTheHighestTheLowestAndTheMean) {
  // Beside the marker by 20 mm along the normal: the slice alone shows soft tissue.
  cursor().moveTo(markerCentre - glm::dvec3(0, 0, 20));
  const glm::dvec3 place = cursor().position();
  const int slice = axial()->slice();
  EXPECT_NEAR(grey(axial(), place), greyOf(40.0), 1.0);
  wheel(axial(), 10, Qt::ShiftModifier);
  EXPECT_EQ(planes().pose(SlicePlane::Axial).slab, (Slab{50.0, SlabMode::Maximum}));
  EXPECT_EQ(axial()->slice(), slice) << "the slice stays";
  EXPECT_EQ(grey(axial(), place), 255) << "the marker is within 25 mm";
  planes().setSlab(SlicePlane::Axial, {100.0, SlabMode::Minimum});
  EXPECT_EQ(grey(axial(), place), 0) << "air above and below the ball";
  planes().setSlab(SlicePlane::Axial, {4.0, SlabMode::Mean});
  EXPECT_NEAR(grey(axial(), place), greyOf(40.0), 1.0);
  EXPECT_EQ(gradeOf(axial()->fidelity()), Fidelity::Altered);
  wheel(axial(), -20, Qt::ShiftModifier);
  EXPECT_EQ(planes().pose(SlicePlane::Axial).slab.thickness, 0.0);
  EXPECT_EQ(gradeOf(axial()->fidelity()), Fidelity::Faithful);

  turn(axial(), SlicePlane::Coronal, 30.0);
  planes().setSlab(SlicePlane::Coronal, {100.0, SlabMode::Maximum});
  EXPECT_EQ(grey(coronal(), markerCentre), 255) << "along a turned plane's normal as well";
}

TEST_F(PlanesWindow, MenusHoldWhatASliceCanDo) {
  QMenu menu;
  fillPlaneMenu(menu, window_->workspace(), SlicePlane::Sagittal);
  const auto entry = [](const QMenu& in, const QString& text) {
    for (QAction* action : in.actions())
      if (action->text() == text) return action;
    return static_cast<QAction*>(nullptr);
  };
  EXPECT_FALSE(entry(menu, QStringLiteral("Reset this slice's plane"))->isEnabled());
  entry(menu, QStringLiteral("Slice faces C2"))->trigger();
  EXPECT_EQ(planes().pose(SlicePlane::Sagittal).follow, PlaneFollow::C2);
  const QMenu& slab = *entry(menu, QStringLiteral("Slab"))->menu();
  entry(slab, QStringLiteral("10 mm"))->trigger();
  entry(slab, QStringLiteral("Minimum (MinIP)"))->trigger();
  EXPECT_EQ(planes().pose(SlicePlane::Sagittal).slab, (Slab{10.0, SlabMode::Minimum}));
  entry(slab, QStringLiteral("All slices as this one"))->trigger();
  EXPECT_EQ(planes().pose(SlicePlane::Axial).slab, (Slab{10.0, SlabMode::Minimum}));
  QMenu again;
  fillPlaneMenu(again, window_->workspace(), SlicePlane::Sagittal);
  EXPECT_TRUE(entry(again, QStringLiteral("Slice faces C2"))->isChecked());
  EXPECT_TRUE(entry(*entry(again, QStringLiteral("Slab"))->menu(), QStringLiteral("10 mm"))->isChecked());
  entry(again, QStringLiteral("Reset this slice's plane"))->trigger();
  EXPECT_FALSE(planes().isTurned(SlicePlane::Sagittal));
}

TEST_F(PlanesWindow, ABallInA3DViewTurnsAPlane) {
  EXPECT_TRUE(volume(0)->planeTool().handles().empty()) << "until they are asked for";
  options().setPlanes(true);
  const std::vector<PlaneBallTool::Handle> handles = volume(0)->planeTool().handles();
  ASSERT_EQ(handles.size(), 3u);
  const Camera camera = cameras().camera(0);
  const PlaneBallTool::Handle& ball = handles[0];
  ASSERT_EQ(ball.plane, SlicePlane::Axial);
  const PlaneAxes before = planes().axes(SlicePlane::Axial);
  const QPoint from = volume(0)->widgetFromWorld(ball.at)->toPoint();
  drag(volume(0), from, from + QPoint(25, 10));
  const PlaneAxes after = planes().axes(SlicePlane::Axial);
  EXPECT_NE(after, before);
  EXPECT_TRUE(isPerpendicular(after));
  EXPECT_EQ(cameras().camera(0), camera) << "the camera stays";
  const double side = glm::dot(before.normal, ball.along);
  EXPECT_GT(glm::dot(after.normal * side, camera.axes().right), glm::dot(ball.along, camera.axes().right) + 0.1)
      << "it follows the mouse";
  EXPECT_FALSE(planes().isMoving(SlicePlane::Axial));
}

TEST_F(PlanesWindow, ASessionBringsPlanesCamerasAndSlabsBack) {
  turn(axial(), SlicePlane::Coronal, 30.0);
  planes().setFollow(SlicePlane::Sagittal, PlaneFollow::C2);
  planes().setSlab(SlicePlane::Axial, {7.0, SlabMode::Mean});
  options().setPlanes(true);
  const io::Session saved = window_->sessions().controller().session();
  EXPECT_EQ(saved.planes, planes().poses());
  io::Study study = markedBall();
  study.session = saved;
  study.restoresSession = true;
  planes().resetAll();
  options().setPlanes(false);
  open(study);
  EXPECT_EQ(planes().pose(SlicePlane::Coronal), saved.planes[2]);
  EXPECT_EQ(planes().pose(SlicePlane::Axial), saved.planes[0]);
  EXPECT_EQ(planes().pose(SlicePlane::Sagittal).follow, PlaneFollow::C2);
  EXPECT_EQ(planes().axes(SlicePlane::Sagittal), axesFacing(cameras().camera(1)));
  EXPECT_TRUE(options().planes());
  EXPECT_EQ(coronal()->sliceGeometry().axis, -1) << "and the view shows it";
  open(markedBall());
  EXPECT_EQ(planes().poses(), (std::array<PlanePose, 3>()));
  EXPECT_GE(coronal()->sliceGeometry().axis, 0);
}

}  // namespace
}  // namespace fenestra::viewer::planesWindowTest
