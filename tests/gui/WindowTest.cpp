// The window, driven as a user drives it: mouse, wheel and keys on a display with OpenGL.

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QOpenGLWidget>
#include <QStatusBar>
#include <QTest>
#include <QTimer>

#include "rendering/Renderer.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/settings/Settings.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/ContextLayerPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelList.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer::windowTest {
namespace {

enum class Side { Negative, Middle, Positive };

/// A side begins a twentieth of the view away from its middle.
Side side(double position) {
  return position < -0.05 ? Side::Negative : position > 0.05 ? Side::Positive : Side::Middle;
}

TEST_F(Window, ShowsEveryViewTheRightWayUp) {
  document().focusOn(marker);
  cursor().moveTo(markerCentre);
  QTest::keyClick(window_.get(), Qt::Key_C);  // the coronal line of the crosshair is green too
  waitUntilDrawn();
  const auto expectAt = [&](QWidget* view, Side across, Side down) {
    SCOPED_TRACE(view->objectName().toStdString());
    const std::optional<QPointF> at = green(view);
    ASSERT_TRUE(at) << "the marker is not seen";
    EXPECT_EQ(side(at->x()), across) << at->x();
    EXPECT_EQ(side(at->y()), down) << at->y();
  };
  expectAt(volume(0), Side::Positive, Side::Negative);                    // from anterior: left is right, superior up
  expectAt(volume(1), Side::Negative, Side::Negative);                    // from the left: anterior is left
  expectAt(slice(SlicePlane::Axial), Side::Positive, Side::Negative);     // left is right, anterior up
  expectAt(slice(SlicePlane::Sagittal), Side::Negative, Side::Negative);  // anterior is left, superior up
  expectAt(slice(SlicePlane::Coronal), Side::Positive, Side::Negative);   // left is right, superior up
}

TEST_F(Window, ClickOnASliceSetsCrosshairAndFocus) {
  cursor().moveTo(markerCentre);
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint onMarker = axial->widgetFromWorld(markerCentre).toPoint();
  QTest::mouseClick(axial, Qt::LeftButton, {}, onMarker);
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{marker}}));

  const QPoint onBody = axial->widgetFromWorld({-10.0, 10.0, 17.0}).toPoint();
  QTest::mouseClick(axial, Qt::LeftButton, Qt::ControlModifier, onBody);
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{body, marker}}));
  // A device-independent pixel is about 0.3 mm here.
  EXPECT_LT(glm::distance(cursor().position(), glm::dvec3(-10.0, 10.0, 17.0)), 1.0);

  QTest::mouseClick(axial, Qt::LeftButton, Qt::ControlModifier, onBody);
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{marker}}));
}

/// Every number of a part of the look that has a step has a slider as declared; returns how many there are.
template <class Part>
int expectSlidersAsDeclared(const QWidget& panel) {
  int sliders = 0;
  forEachSetting<Part>([&](const auto& setting) {
    if (setting.step == 0.0) return;
    const auto* slider = panel.findChild<SliderSpin*>(QString::fromUtf8(setting.key));
    ASSERT_NE(slider, nullptr) << setting.key;
    ++sliders;
    EXPECT_EQ(slider->box()->minimum(), setting.slider.low) << setting.key;
    EXPECT_EQ(slider->box()->maximum(), setting.slider.high) << setting.key;
    EXPECT_EQ(slider->box()->singleStep(), setting.step) << setting.key;
    EXPECT_EQ(slider->slider()->maximum(), std::lround((setting.slider.high - setting.slider.low) / setting.step));
    EXPECT_EQ(slider->toolTip(), QString::fromUtf8(setting.description)) << setting.key;
  });
  return sliders;
}

TEST_F(Window, SlidersAreThoseOfTheDeclaredSettings) {
  EXPECT_EQ(expectSlidersAsDeclared<Cutaway>(panel<CutawayPanel>()), 3);
  int sliders = 0;
  forEachMethod([&]<class M>() { sliders += expectSlidersAsDeclared<M>(panel<CutawayPanel>()); });
  EXPECT_EQ(sliders, 19);
  EXPECT_EQ(expectSlidersAsDeclared<CarvingSettings>(panel<CutawayPanel>()), 3);
  EXPECT_EQ(panel<CutawayPanel>().findChildren<SliderSpin*>().size(), 25) << "one each";
  EXPECT_EQ(expectSlidersAsDeclared<ContextLayer>(panel<ContextLayerPanel>()), 7);
  EXPECT_EQ(panel<ContextLayerPanel>().findChildren<SliderSpin*>().size(), 7) << "one each";
}

TEST_F(Window, ATypedFocusValueIsOneStepAndUndoneFromItsBox) {
  document().setFocus(ValueFocus{{123.0, 800.0}, 0.0});
  auto boxes = panel<FocusPanel>().findChildren<QDoubleSpinBox*>();
  const auto low =
      std::find_if(boxes.begin(), boxes.end(), [](const QDoubleSpinBox* box) { return box->value() == 123.0; });
  ASSERT_NE(low, boxes.end());
  const int steps = document().undoStack().index();
  (*low)->setFocus();
  (*low)->selectAll();
  QTest::keyClicks(*low, QStringLiteral("250"));
  QTest::keyClick(*low, Qt::Key_Return);
  EXPECT_EQ(document().focus(), Focus(ValueFocus{{250.0, 800.0}, 0.0}));
  EXPECT_EQ(document().undoStack().index(), steps + 1);
  QTest::keyClick(*low, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().focus(), Focus(ValueFocus{{123.0, 800.0}, 0.0}));
  EXPECT_EQ((*low)->value(), 123.0);
}

TEST_F(Window, DraggingAViewTurnsItsPartnerToo) {
  const auto basis = [](const Camera& camera) {
    const Camera::Axes axes = camera.axes();
    return glm::dmat3(axes.right, axes.up, -axes.forward);
  };
  const glm::dmat3 first = basis(cameras().camera(0)), second = basis(cameras().camera(1));
  drag(volume(0), {200, 150}, {280, 190});
  const glm::dmat3 firstTurn = basis(cameras().camera(0)) * glm::transpose(first);
  const glm::dmat3 secondTurn = basis(cameras().camera(1)) * glm::transpose(second);
  for (int column = 0; column < 3; ++column) EXPECT_LT(glm::distance(firstTurn[column], secondTurn[column]), 1e-9);
  EXPECT_LT(firstTurn[0][0], 0.95) << "80 pixels are more than 18 degrees";
  // The surface follows the mouse: the front moves right, so the camera goes to the patient's right.
  EXPECT_LT(cameras().camera(0).eye.x, -10.0);
  // And down, so the camera looks from above.
  EXPECT_GT(cameras().camera(0).eye.z, 10.0);

  QTest::keyClick(window_.get(), Qt::Key_L);
  const Camera partner = cameras().camera(1);
  drag(volume(0), {200, 150}, {240, 150});
  EXPECT_EQ(cameras().camera(1), partner);
}

TEST_F(Window, ClickInAVolumeViewMovesTheCrosshairToTheSurface) {
  // The ball's point nearest to the anterior camera is at y = -44.
  const std::optional<QPointF> at = volume(0)->widgetFromWorld({0.0, -44.0, 0.0});
  ASSERT_TRUE(at);
  QTest::mouseClick(volume(0), Qt::LeftButton, {}, at->toPoint());
  // Half a voxel below the surface, which lies within a voxel of the ball's; a pixel is about half a millimetre.
  EXPECT_LT(glm::distance(cursor().position(), glm::dvec3(0.0, -43.0, 0.0)), 2.5);
}

TEST_F(Window, WheelAndArrowsStepThroughSlices) {
  for (SliceView* view : views().sliceViews()) {
    const int before = view->slice();
    wheel(view, 2);
    EXPECT_EQ(view->slice(), before + 2);
    QTest::keyClick(view, Qt::Key_Down);
    EXPECT_EQ(view->slice(), before + 1);
  }
}

TEST_F(Window, DragOnASliceChangesWindowAndLevel) {
  SliceView* coronal = slice(SlicePlane::Coronal);
  const WindowLevel before = document().window();
  const glm::dvec3 crosshair = cursor().position();
  drag(coronal, {100, 100}, {150, 130});
  EXPECT_GT(document().window().width, before.width + 10.0);
  EXPECT_GT(document().window().level, before.level + 10.0);
  EXPECT_EQ(cursor().position(), crosshair) << "a drag is no click";
  QTest::keyClick(window_.get(), Qt::Key_7);
  EXPECT_EQ(document().window(), (WindowLevel{1500.0, -500.0}));
  QTest::keyClick(window_.get(), Qt::Key_1);
  EXPECT_EQ(document().window(), before);
}

TEST_F(Window, ZoomAndPanOfASliceKeepWhatIsUnderTheMouse) {
  SliceView* axial = slice(SlicePlane::Axial);
  const QPointF middle = axial->rect().center();
  const glm::dvec3 world = axial->worldFromWidget(middle);
  wheel(axial, 5, Qt::ControlModifier);
  EXPECT_LT(glm::distance(axial->worldFromWidget(middle), world), 1e-6);
  EXPECT_LT(glm::distance(axial->worldFromWidget(middle + QPointF(50, 0)), world), 10.0);
  drag(axial, {100, 100}, {140, 80}, Qt::MiddleButton);
  EXPECT_LT(glm::distance(axial->worldFromWidget(middle + QPointF(40, -20)), world), 1e-6);
  axial->setFocus();
  QTest::keyClick(axial, Qt::Key_R);
  EXPECT_LT(
      glm::distance(axial->worldFromWidget(QPointF(axial->width(), axial->height()) / 2.0), glm::dvec3(0, 0, world.z)),
      1e-6);
}

TEST_F(Window, KeysTurnTheCamerasToStandardViews) {
  volume(1)->setFocus();
  const ViewLink::Pose before = cameras().pose();
  QTest::keyClick(volume(1), Qt::Key_S, Qt::ShiftModifier);
  EXPECT_LT(glm::distance(cameras().camera(1).axes().forward, glm::dvec3(0, 0, -1)), 1e-9);
  const ViewLink::Pose above = cameras().pose();
  QTest::keyClick(volume(1), Qt::Key_S, Qt::ShiftModifier);
  EXPECT_EQ(document().undoStack().count(), 1) << "nothing moved";
  QTest::keyClick(volume(1), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(cameras().pose(), before);
  QTest::keyClick(volume(1), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(cameras().pose(), above);
  QTest::keyClick(volume(1), Qt::Key_R);
  EXPECT_LT(glm::distance(cameras().camera(1).axes().forward, glm::dvec3(-1, 0, 0)), 1e-9);
}

TEST_F(Window, DoubleClickMaximisesAndUndoesItsFirstClick) {
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint at = axial->rect().center();
  document().focusOn(marker);
  const glm::dvec3 crosshair = cursor().position();
  QTest::mouseClick(axial, Qt::LeftButton, {}, at + QPoint(20, 10));
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{body}}));
  QTest::mouseDClick(axial, Qt::LeftButton, {}, at + QPoint(20, 10));
  EXPECT_TRUE(views().isMaximised());
  EXPECT_TRUE(axial->isVisible());
  EXPECT_FALSE(volume(0)->isVisible());
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{marker}}));
  EXPECT_EQ(document().undoStack().count(), 1) << "the focus that was chosen before, and nothing else";
  EXPECT_LT(glm::distance(cursor().position(), crosshair), 1e-6);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(volume(0)->isVisible());
  waitUntilDrawn();
}

TEST_F(Window, TicksAndFilterWorkOnTheLabelList) {
  FocusPanel& focus = panel<FocusPanel>();
  QTest::keyClicks(focus.filter(), QStringLiteral("MARK"));
  ASSERT_EQ(focus.list()->model()->rowCount(), 1) << "letters typed into the filter are no shortcuts";
  const QModelIndex row = focus.list()->model()->index(0, 0);
  EXPECT_EQ(row.data().toString(), QStringLiteral("marker"));
  focus.list()->model()->setData(row, Qt::Checked, Qt::CheckStateRole);
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{marker}}));
  QTest::mouseClick(focus.byValue(), Qt::LeftButton, {}, QPoint(6, focus.byValue()->height() / 2));
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(document().focus()));
  EXPECT_EQ(row.data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
}

TEST_F(Window, TheFocusRingLeavesABoxToTickFree) {
  const auto ring = [this] { return window_->findChild<QWidget*>(QStringLiteral("focusRing")); };
  auto* box = panel<CutawayPanel>().findChild<QCheckBox*>();
  QApplication::setActiveWindow(window_.get());
  box->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return ring() && ring()->isVisible(); }, patience));
  const QRect at(ring()->mapToGlobal(QPoint(0, 0)), ring()->size());
  constexpr int line = 2;  // device-independent pixels, the ring's width
  EXPECT_TRUE(at.adjusted(line, line, -line, -line).contains(QRect(box->mapToGlobal(QPoint(0, 0)), box->size())));
  box->clearFocus();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !ring(); }, patience));
}

TEST_F(Window, Thorough_CrosshairGoesToAFocusThatIsChosenByNameOrOpened) {
  LabelList* list = panel<FocusPanel>().list();
  list->doubleClicked(list->model()->index(1, 0));
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{marker}}));
  const auto atMarker = [&] { return glm::distance(cursor().position(), markerCentre) < 1e-6; };
  EXPECT_TRUE(QTest::qWaitFor(atMarker, patience));

  io::Study focused = markedBall();
  focused.scene.look.focus = ValueFocus{.values = {500.0, 1000.0}};  // reaches a voxel around the marker
  open(focused);
  EXPECT_TRUE(atMarker());
  open(markedBall());
  EXPECT_LT(glm::length(cursor().position()), 1.0 + 1e-6) << "without a focus: the volume's middle";
}

TEST_F(Window, TheOpeningsEdgeIsDrawnOnTheSlices) {
  cursor().moveTo(markerCentre);
  document().focusOn(marker);
  waitUntilDrawn();
  SliceView* axial = slice(SlicePlane::Axial);
  const QPainterPath edge = axial->openingEdge();
  ASSERT_FALSE(edge.isEmpty());
  // C1 looks from anterior: the body before the marker is removed, and what lies behind or beside it is not.
  EXPECT_TRUE(edge.contains(axial->widgetFromWorld(markerCentre - glm::dvec3(0, 12, 0))));
  EXPECT_FALSE(edge.contains(axial->widgetFromWorld(markerCentre + glm::dvec3(0, 20, 0))));
  EXPECT_FALSE(edge.contains(axial->widgetFromWorld(markerCentre - glm::dvec3(45, 0, 0))));
  EXPECT_FALSE(edge.contains(axial->widgetFromWorld(markerCentre - glm::dvec3(0, 29, 0)))) << "air before the body";
  options().setCrosshair(false);
  const QImage with = picture(axial);
  cameras().orbit(0, 0.5, 0.0);
  EXPECT_TRUE(axial->openingEdge().isEmpty()) << "while C1 moves";
  waitUntilDrawn();
  EXPECT_FALSE(axial->openingEdge().isEmpty());
  EXPECT_NE(picture(axial), with);
  Look closed = document().look();
  closed.cutaway.enabled = false;
  document().edit({}, closed);
  waitUntilDrawn();
  EXPECT_TRUE(axial->openingEdge().isEmpty());
}

TEST_F(Window, NamesWhatIsUnderTheMouse) {
  cursor().moveTo(markerCentre);
  SliceView* axial = slice(SlicePlane::Axial);
  const auto text = [&] {
    QStringList texts;
    for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char('|'));
  };
  // Sent, not moved: moves of the pointer that come close after one another may reach the window as one.
  for (const QPointF place :
       {QPointF(axial->rect().center()) + QPointF(1.0, 1.0), axial->widgetFromWorld(markerCentre)}) {
    QMouseEvent event(QEvent::MouseMove, place, axial->mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(axial, &event);
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return text().contains(QStringLiteral("marker")); }, patience))
      << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("900 HU"))) << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("S 17.0"))) << text().toStdString();
}

/// A ball of soft tissue over a plate, in a CT.
io::Study ballOverTable() {
  io::Study study = markedBall();
  auto volume = std::make_shared<Volume>();
  volume->grid = study.scene.volume->grid;
  volume->modality = Modality::CT;
  volume->unit = "HU";
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  auto values = volume->voxels.as<std::int16_t>();
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const glm::dvec3 world = volume->grid.origin + 2.0 * glm::dvec3(x, y, z);
        const bool isTable = std::abs(world.y - 42.0) < 2.5 && std::abs(world.x) < 42.0;
        const bool isShown = isTable || glm::length(world) < 24.0;
        values[volume->grid.offset({x, y, z})] = static_cast<std::int16_t>(isShown ? 40 : -1000);
      }
  volume->computeRange();
  study.scene.volume = volume;
  study.scene.labels = nullptr;
  return study;
}

TEST_F(Window, ASwitchShowsAndHidesTheTable) {
  open(ballOverTable());
  options().setText(false);
  options().setCrosshair(false);
  auto* hides = window_->findChild<AppearancePanel*>()->findChild<QCheckBox*>(QStringLiteral("hide_table"));
  ASSERT_NE(hides, nullptr);
  EXPECT_TRUE(hides->isChecked());
  // Above the ball, where the plate behind it shows from the front.
  const auto shows = [&] {
    const std::optional<QPointF> at = volume(0)->widgetFromWorld({0.0, 42.0, 34.0});
    const QImage seen = picture(volume(0));
    const double scale = static_cast<double>(seen.width()) / volume(0)->width();
    return at && seen.pixelColor((*at * scale).toPoint()).red() > 60;
  };
  waitUntilDrawn();
  cameras().zoom(0, 0.5);
  const Camera camera = cameras().camera(0);
  waitUntilDrawn();
  EXPECT_FALSE(shows());
  hides->click();
  waitUntilDrawn();
  EXPECT_TRUE(shows());
  EXPECT_EQ(cameras().camera(0), camera) << "the camera stays";
  hides->click();
  waitUntilDrawn();
  EXPECT_FALSE(shows());
}

}  // namespace
}  // namespace fenestra::viewer::windowTest
