// The window, driven as a user drives it: mouse, wheel and keys on a display with OpenGL.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QUrl>
#include <QWheelEvent>

#include "io/VolumeWriter.h"
#include "tests/support/TestData.h"
#include "viewer/MainWindow.h"
#include "viewer/NoticeBar.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/panels/SphereMap.h"

namespace fenestra::viewer {
namespace {

constexpr int patience = 30000;  ///< ms; reached only when something hangs
constexpr std::uint16_t body = 1, marker = 2;

/// Where the marker is: to the patient's left, anterior and superior of the middle.
const glm::dvec3 markerCentre(17.0, -17.0, 17.0);

/// A ball of soft tissue with a green cube of bone in it, 48³ voxels of 2 mm around the world's origin.
Study markedBall() {
  auto volume = std::make_shared<Volume>();
  auto labels = std::make_shared<LabelMap>();
  volume->grid = labels->grid = {.dims = glm::ivec3(48), .spacing = glm::dvec3(2.0), .origin = glm::dvec3(-47.0)};
  volume->modality = Modality::CT;
  volume->unit = "HU";
  volume->windows = {{400.0, 40.0}};
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  labels->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  auto values = volume->voxels.as<std::int16_t>();
  auto marks = labels->voxels.as<std::uint8_t>();
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const glm::dvec3 world = volume->grid.origin + 2.0 * glm::dvec3(x, y, z);
        const glm::dvec3 offset = glm::abs(world - markerCentre);
        const bool isMarker = std::max({offset.x, offset.y, offset.z}) < 7.0, isBody = glm::length(world) < 44.0;
        const std::size_t at = volume->grid.offset({x, y, z});
        values[at] = static_cast<std::int16_t>(isMarker ? 900 : isBody ? 40 : -1000);
        marks[at] = static_cast<std::uint8_t>(isMarker ? marker : isBody ? body : 0);
      }
  volume->computeRange();
  labels->labels = {{body, "body", {0.9, 0.6, 0.5}}, {marker, "marker", {0.1, 1.0, 0.1}}};
  Study study;
  study.scene.volume = volume;
  study.scene.labels = labels;
  study.scene.context.nodes = {{-200.0, {{0.9, 0.6, 0.5}, 0.0}}, {0.0, {{0.9, 0.6, 0.5}, 1.0}}};
  return study;
}

/// A window that shows the marked ball.
class Window : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(gl_.available) << gl_.problem.toStdString();
    // Draft, because what is tested here does not depend on the sampling and the machine may have no GPU.
    window_ =
        std::make_unique<MainWindow>(MainWindow::Setup{.gl = gl_, .restQuality = Quality::Draft, .remember = false});
    window_->resize(1280, 800);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // Xvfb has no window manager to do it; keys need it
    setAutomatic(false);
    open(markedBall());
  }

  void open(const Study& study) {
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->open([study](const io::Progress&) { return study; });
    ASSERT_TRUE(opened.wait(patience));
    waitUntilDrawn();
  }

  void waitUntilDrawn() {
    bool drawn = false;
    window_->whenDrawn([&] { drawn = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return drawn; }, patience));
  }

  /// Whether a chosen focus moves the cameras: only where that is what is tested.
  void setAutomatic(bool on) {
    PlacementSettings settings = window_->placement().settings();
    settings.automatic = on;
    window_->placement().setSettings(settings);
  }

  VolumeView* volume(std::size_t index) { return window_->views().volumeViews().at(index); }
  SliceView* slice(SlicePlane plane) { return window_->views().sliceViews().at(static_cast<std::size_t>(plane)); }

  void drag(QWidget* widget, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(widget, button, {}, from);
    constexpr int steps = 4;
    for (int step = 1; step <= steps; ++step) {
      const QPoint at = from + (to - from) * step / steps;
      QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, {});
      QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, button, {}, to);
  }

  void wheel(QWidget* widget, int notches, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF at = widget->rect().center();
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(widget, &event);
  }

  /// Centre of the green pixels that a view shows, from -1 (left, top) to 1 (right, bottom); empty when there are few.
  std::optional<QPointF> green(QWidget* view) {
    const QImage picture = window_->picture();
    const double ratio = picture.devicePixelRatio();
    const QPoint corner = view->mapTo(window_.get(), QPoint(0, 0));
    const QRect area(QPoint(std::lround(corner.x() * ratio), std::lround(corner.y() * ratio)),
                     QSize(std::lround(view->width() * ratio), std::lround(view->height() * ratio)));
    QPointF sum;
    int count = 0;
    for (int y = area.top(); y <= area.bottom(); ++y)
      for (int x = area.left(); x <= area.right(); ++x) {
        const QColor colour = picture.pixelColor(x, y);
        if (colour.green() < colour.red() + 60 || colour.green() < colour.blue() + 60) continue;
        sum += QPointF(x, y);
        ++count;
      }
    if (count < 30) return std::nullopt;
    const QPointF mean = sum / count - QRectF(area).center();
    return QPointF(2.0 * mean.x() / area.width(), 2.0 * mean.y() / area.height());
  }

  const GlSupport gl_ = probeOpenGl();
  std::unique_ptr<MainWindow> window_;
};

enum class Side { Negative, Middle, Positive };

/// Beyond a twentieth of the view from its middle is a side.
Side side(double position) {
  return position < -0.05 ? Side::Negative : position > 0.05 ? Side::Positive : Side::Middle;
}

TEST_F(Window, ShowsEveryViewTheRightWayUp) {
  window_->document().focusOn(marker);
  window_->cursor().moveTo(markerCentre);
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
  window_->cursor().moveTo(markerCentre);
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint onMarker = axial->widgetFromWorld(markerCentre).toPoint();
  QTest::mouseClick(axial, Qt::LeftButton, {}, onMarker);
  EXPECT_EQ(window_->document().focus(), Focus(LabelFocus{{marker}}));

  const QPoint onBody = axial->widgetFromWorld({-10.0, 10.0, 17.0}).toPoint();
  QTest::mouseClick(axial, Qt::LeftButton, Qt::ControlModifier, onBody);
  EXPECT_EQ(window_->document().focus(), Focus(LabelFocus{{body, marker}}));
  // A device-independent pixel is about 0.3 mm here.
  EXPECT_LT(glm::distance(window_->cursor().position(), glm::dvec3(-10.0, 10.0, 17.0)), 1.0);

  QTest::mouseClick(axial, Qt::LeftButton, Qt::ControlModifier, onBody);
  EXPECT_EQ(window_->document().focus(), Focus(LabelFocus{{marker}}));
}

TEST_F(Window, OpeningSliderChangesThePicture) {
  window_->document().focusOn(marker);
  waitUntilDrawn();
  const QImage before = window_->picture();
  QSlider* slider = window_->cutawayPanel().openWidth()->slider();
  const double width = window_->document().scene().cutaway.openWidth;
  const int handle = slider->width() * slider->value() / slider->maximum();
  drag(slider, {handle, slider->height() / 2}, {slider->width() * 3 / 4, slider->height() / 2});
  EXPECT_GT(window_->document().scene().cutaway.openWidth, width + 20.0);
  EXPECT_DOUBLE_EQ(window_->cutawayPanel().openWidth()->box()->value(), window_->document().scene().cutaway.openWidth);
  waitUntilDrawn();
  const QImage after = window_->picture();
  const QPoint corner = volume(0)->mapTo(window_.get(), QPoint(0, 0)) * before.devicePixelRatio();
  const QRect area(corner, volume(0)->size() * before.devicePixelRatio());
  EXPECT_NE(before.copy(area), after.copy(area));
}

TEST_F(Window, DraggingAViewTurnsItsPartnerToo) {
  const auto basis = [](const Camera& camera) {
    const Camera::Axes axes = camera.axes();
    return glm::dmat3(axes.right, axes.up, -axes.forward);
  };
  const glm::dmat3 first = basis(window_->cameras().camera(0)), second = basis(window_->cameras().camera(1));
  drag(volume(0), {200, 150}, {280, 190});
  const glm::dmat3 firstTurn = basis(window_->cameras().camera(0)) * glm::transpose(first);
  const glm::dmat3 secondTurn = basis(window_->cameras().camera(1)) * glm::transpose(second);
  for (int column = 0; column < 3; ++column) EXPECT_LT(glm::distance(firstTurn[column], secondTurn[column]), 1e-9);
  EXPECT_LT(firstTurn[0][0], 0.95) << "80 pixels are more than 18 degrees";
  // What was under the mouse goes with it: the front moves right, so the camera goes to the patient's right.
  EXPECT_LT(window_->cameras().camera(0).eye.x, -10.0);
  // And down, so the camera looks from above.
  EXPECT_GT(window_->cameras().camera(0).eye.z, 10.0);

  QTest::keyClick(window_.get(), Qt::Key_L);
  const Camera partner = window_->cameras().camera(1);
  drag(volume(0), {200, 150}, {240, 150});
  EXPECT_EQ(window_->cameras().camera(1), partner);
}

TEST_F(Window, ClickInAVolumeViewMovesTheCrosshairToTheSurface) {
  // The ball's point nearest to the anterior camera is at y = -44.
  const std::optional<QPointF> at = volume(0)->widgetFromWorld({0.0, -44.0, 0.0});
  ASSERT_TRUE(at);
  QTest::mouseClick(volume(0), Qt::LeftButton, {}, at->toPoint());
  // Half a voxel below the surface, which lies within a voxel of the ball's; a pixel is about half a millimetre.
  EXPECT_LT(glm::distance(window_->cursor().position(), glm::dvec3(0.0, -43.0, 0.0)), 2.5);
}

TEST_F(Window, WheelAndArrowsStepThroughSlices) {
  for (SliceView* view : window_->views().sliceViews()) {
    const int before = view->slice();
    wheel(view, 2);
    EXPECT_EQ(view->slice(), before + 2);
    QTest::keyClick(view, Qt::Key_Down);
    EXPECT_EQ(view->slice(), before + 1);
  }
}

TEST_F(Window, DragOnASliceChangesWindowAndLevel) {
  SliceView* coronal = slice(SlicePlane::Coronal);
  const WindowLevel before = window_->document().window();
  const glm::dvec3 cursor = window_->cursor().position();
  drag(coronal, {100, 100}, {150, 130});
  EXPECT_GT(window_->document().window().width, before.width + 10.0);
  EXPECT_GT(window_->document().window().level, before.level + 10.0);
  EXPECT_EQ(window_->cursor().position(), cursor) << "a drag is no click";
  QTest::keyClick(window_.get(), Qt::Key_7);
  EXPECT_EQ(window_->document().window(), (WindowLevel{1500.0, -500.0}));
  QTest::keyClick(window_.get(), Qt::Key_1);
  EXPECT_EQ(window_->document().window(), before);
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
  QTest::keyClick(volume(1), Qt::Key_S, Qt::ShiftModifier);
  EXPECT_LT(glm::distance(window_->cameras().camera(1).axes().forward, glm::dvec3(0, 0, -1)), 1e-9);
  QTest::keyClick(volume(1), Qt::Key_R);
  EXPECT_LT(glm::distance(window_->cameras().camera(1).axes().forward, glm::dvec3(-1, 0, 0)), 1e-9);
}

TEST_F(Window, DoubleClickMaximisesAndUndoesItsFirstClick) {
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint at = axial->rect().center();
  window_->document().focusOn(marker);
  const glm::dvec3 cursor = window_->cursor().position();
  QTest::mouseClick(axial, Qt::LeftButton, {}, at + QPoint(20, 10));
  EXPECT_EQ(window_->document().focus(), Focus(LabelFocus{{body}}));
  QTest::mouseDClick(axial, Qt::LeftButton, {}, at + QPoint(20, 10));
  EXPECT_TRUE(window_->views().isMaximised());
  EXPECT_TRUE(axial->isVisible());
  EXPECT_FALSE(volume(0)->isVisible());
  EXPECT_EQ(window_->document().focus(), Focus(LabelFocus{{marker}}));
  EXPECT_LT(glm::distance(window_->cursor().position(), cursor), 1e-6);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_TRUE(volume(0)->isVisible());
  waitUntilDrawn();
}

TEST_F(Window, TicksAndFilterWorkOnTheLabelList) {
  FocusPanel& panel = window_->focusPanel();
  QTest::keyClicks(panel.filter(), QStringLiteral("MARK"));
  ASSERT_EQ(panel.list()->model()->rowCount(), 1) << "letters typed into the filter are no shortcuts";
  const QModelIndex row = panel.list()->model()->index(0, 0);
  EXPECT_EQ(row.data().toString(), QStringLiteral("marker"));
  panel.list()->model()->setData(row, Qt::Checked, Qt::CheckStateRole);
  EXPECT_EQ(window_->document().focus(), Focus(LabelFocus{{marker}}));
  QTest::mouseClick(panel.byValue(), Qt::LeftButton, {}, QPoint(6, panel.byValue()->height() / 2));
  EXPECT_TRUE(std::holds_alternative<ValueFocus>(window_->document().focus()));
  EXPECT_EQ(row.data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
}

TEST_F(Window, NamesWhatIsUnderTheMouse) {
  window_->cursor().moveTo(markerCentre);
  SliceView* axial = slice(SlicePlane::Axial);
  QTest::mouseMove(axial, axial->rect().center() + QPoint(1, 1));
  QTest::mouseMove(axial, axial->widgetFromWorld(markerCentre).toPoint());
  const auto text = [&] {
    QStringList texts;
    for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char('|'));
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return text().contains(QStringLiteral("marker")); }, patience))
      << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("900 HU"))) << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("S 17.0"))) << text().toStdString();
}

TEST_F(Window, ABrokenFileIsToldAndTheOldStudyStays) {
  const std::filesystem::path broken = tests::scratchFolder() / "broken.nii";
  std::ofstream(broken) << "not a volume";
  window_->document().focusOn(marker);
  const auto volumeBefore = window_->document().scene().volume;
  QSignalSpy failed(window_.get(), &MainWindow::failed);
  window_->open(std::vector{broken});
  ASSERT_TRUE(failed.wait(patience));
  ASSERT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("broken.nii")));
  EXPECT_EQ(window_->document().scene().volume, volumeBefore);
  EXPECT_TRUE(window_->document().isFocused(marker));
  waitUntilDrawn();
}

TEST_F(Window, DroppedFilesAreOpened) {
  auto half = std::make_shared<Volume>();
  half->grid = {.dims = {12, 10, 8}, .spacing = glm::dvec3(3.0)};
  half->voxels = Voxels(ScalarType::UInt8, half->grid.voxelCount());
  for (std::size_t i = 0; i < half->voxels.count(); ++i) half->voxels.as<std::uint8_t>()[i] = i % 12 < 6 ? 0 : 5;
  half->computeRange();
  const std::filesystem::path file = tests::scratchFolder() / "Größe 頭部.mha";
  io::writeVolume(*half, file);

  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(toQString(file)), QUrl::fromLocalFile(toQString(file))});
  QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(400, 300), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  QApplication::sendEvent(window_.get(), &drop);
  ASSERT_TRUE(opened.wait(patience));
  const Scene& scene = window_->document().scene();
  EXPECT_EQ(scene.volume->grid.dims, half->grid.dims);
  ASSERT_NE(scene.labels, nullptr) << "the second file is the first one's label map";
  ASSERT_EQ(scene.labels->labels.size(), 1u);
  EXPECT_EQ(scene.labels->labels[0].value, 5);
  waitUntilDrawn();
}

TEST_F(Window, LabelsAreOpenedOverTheStudy) {
  auto marks = std::make_shared<Volume>();
  marks->grid = window_->document().scene().volume->grid;
  marks->voxels = Voxels(ScalarType::UInt8, marks->grid.voxelCount());
  for (std::size_t i = 0; i < marks->voxels.count(); ++i) marks->voxels.as<std::uint8_t>()[i] = i % 48 < 24 ? 3 : 0;
  marks->computeRange();
  const std::filesystem::path file = tests::scratchFolder() / "labels.nrrd";
  io::writeVolume(*marks, file);
  window_->document().focusOn(marker);
  QSignalSpy changed(&window_->document(), &Document::labelsChanged);
  window_->openLabels(file);
  ASSERT_TRUE(changed.wait(patience));
  EXPECT_EQ(window_->focusPanel().list()->model()->rowCount(), 1);
  EXPECT_EQ(window_->document().focus(), Focus()) << "the old labels are gone";
  waitUntilDrawn();
}

TEST_F(Window, RemembersLayoutAndRecentFilesOnlyWhenAsked) {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(tests::scratchFolder().string()));
  QCoreApplication::setOrganizationName(QStringLiteral("Fenestra tests"));
  const auto cutawayDock = [](MainWindow& window) {
    return window.findChild<QDockWidget*>(QStringLiteral("cutawayDock"));
  };
  MainWindow::Setup setup{.gl = {.problem = QStringLiteral("slices are enough here")}};
  const auto closeWithoutDock = [&] {
    MainWindow window(setup);
    window.show();
    cutawayDock(window)->hide();
    QSignalSpy opened(&window, &MainWindow::opened);
    window.open([](const io::Progress&) {
      Study study = markedBall();
      study.path = "/data/scan.nii";
      return study;
    });
    EXPECT_TRUE(opened.wait(patience));
    window.close();
  };
  setup.remember = false;
  closeWithoutDock();
  EXPECT_TRUE(Preferences().recent().empty());
  setup.remember = true;
  closeWithoutDock();
  EXPECT_EQ(Preferences().recent(), std::vector<std::filesystem::path>{"/data/scan.nii"});
  MainWindow again(setup);
  again.show();
  EXPECT_FALSE(cutawayDock(again)->isVisible());
}

TEST_F(Window, WarningsAreShownOnceEach) {
  Study study = markedBall();
  study.warnings = {{io::Warning::Kind::UnevenSpacing, "slices are uneven", {"a.dcm", "b.dcm"}},
                    {io::Warning::Kind::UnevenSpacing, "slices are uneven", {"a.dcm", "b.dcm"}},
                    {io::Warning::Kind::GantryTilt, "the gantry was tilted", {}}};
  open(study);
  EXPECT_EQ(window_->notices().texts(),
            (QStringList{QStringLiteral("Slices are uneven."), QStringLiteral("The gantry was tilted.")}));
  open(markedBall());
  EXPECT_TRUE(window_->notices().texts().isEmpty());
}

TEST_F(Window, ReadingCanBeCancelled) {
  const auto volumeBefore = window_->document().scene().volume;
  window_->open([](const io::Progress& progress) -> Study {
    while (progress(0.5, "reading slices")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    throw io::Cancelled();
  });
  const auto cancel = [&]() -> QPushButton* {
    for (QPushButton* button : window_->findChildren<QPushButton*>())
      if (button->isVisible() && button->text() == QStringLiteral("Cancel")) return button;
    return nullptr;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return cancel() != nullptr; }, patience));
  QTest::mouseClick(cancel(), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return cancel() == nullptr; }, patience));
  EXPECT_TRUE(window_->notices().texts().isEmpty());
  EXPECT_EQ(window_->document().scene().volume, volumeBefore);
}

TEST_F(Window, TitleAndPanelsNameNoFile) {
  Study study = markedBall();
  study.path = "/data/Doe^Jane/scan.nii";
  study.series.description = "Jane Doe, head";
  open(study);
  EXPECT_FALSE(window_->windowTitle().contains(QStringLiteral("Doe")));
  for (const QLabel* label : window_->findChildren<QLabel*>())
    EXPECT_FALSE(label->text().contains(QStringLiteral("Doe"))) << label->text().toStdString();
}

/// The marked ball with the marker in focus and both cameras placed for it.
class PlacedWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    setAutomatic(true);
    auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("camerasDock"));
    dock->raise();
    window_->cursor().moveTo(markerCentre);
    SliceView* axial = slice(SlicePlane::Axial);
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->widgetFromWorld(markerCentre).toPoint());
    ASSERT_TRUE(window_->placement().isBusy());
    waitUntilDrawn();
    ASSERT_NE(window_->placement().measured(), nullptr);
  }

  PlacementController& placement() { return window_->placement(); }
  glm::dvec3 direction(int view) { return directionOf(window_->cameras().camera(view)); }
  glm::dvec3 candidate(std::size_t index) { return placement().measured()->candidates.at(index).direction; }

  static constexpr double same = 1e-9;  ///< of unit vectors after a few operations in double precision
};

TEST_F(PlacedWindow, ChoosingALabelMovesBothViewsToTheAnswer) {
  const auto answer =
      placement::choose(*placement().measured(), placement().settings().options, placement().settings().joint);
  ASSERT_TRUE(answer.c1 && answer.c2);
  EXPECT_LT(glm::distance(direction(0), candidate(*answer.c1)), same);
  EXPECT_LT(glm::distance(direction(1), candidate(*answer.c2)), same);
  EXPECT_GT(glm::dot(direction(0), glm::normalize(markerCentre)), 0.0) << "from the side where the marker lies";
  for (const std::size_t view : {0u, 1u}) EXPECT_TRUE(green(volume(view))) << "view " << view;
  // A convex focus shows less than half of itself to one camera and no more than three quarters to two at right angles.
  ASSERT_TRUE(placement().share());
  EXPECT_NEAR(*placement().share(), answer.share, same);
  EXPECT_GT(answer.share, 0.5);
  const QString percent = QString::number(100.0 * answer.share, 'f', 0);
  EXPECT_TRUE(window_->camerasPanel().share()->text().contains(percent));
}

TEST_F(PlacedWindow, MeasuringInSlicesChangesNothing) {
  ASSERT_TRUE(volume(0)->inContext([&](const std::shared_ptr<GpuScene>& gpu) {
    const PlacementSettings& settings = placement().settings();
    placement::Placer placer;
    const placement::Measured& whole =
        placer.measure(*gpu, window_->document().scene(), settings.sampling, settings.options);
    const placement::Measured& sliced = *placement().measured();
    ASSERT_EQ(sliced.candidates.size(), whole.candidates.size());
    EXPECT_EQ(sliced.spread, 192u);
    EXPECT_EQ(sliced.spread, whole.spread);
    EXPECT_EQ(sliced.surfacePoints, whole.surfacePoints);
    for (std::size_t i = 0; i < whole.candidates.size(); ++i) {
      const placement::Candidate &a = sliced.candidates[i], &b = whole.candidates[i];
      EXPECT_EQ(a.direction, b.direction);
      EXPECT_EQ(a.sums.count, b.sums.count);
      EXPECT_EQ(a.sums.depth, b.sums.depth);
      EXPECT_EQ(a.seen, b.seen);
      EXPECT_EQ(a.descriptors.stability, b.descriptors.stability);
    }
  }));
}

TEST_F(PlacedWindow, TheWheelScrollsThePanelAndChangesNoValue) {
  CamerasPanel& panel = window_->camerasPanel();
  volume(0)->setFocus();
  const PlacementSettings before = placement().settings();
  wheel(panel.sampling(), 1);
  wheel(panel.weight(0)->slider(), 1);
  EXPECT_EQ(placement().settings(), before);
  panel.weight(0)->slider()->setFocus();
  wheel(panel.weight(0)->slider(), 1);
  EXPECT_NE(placement().settings(), before);
  waitUntilDrawn();
}

TEST_F(PlacedWindow, DraggingC1MovesC2WithinItsRegion) {
  const glm::dvec3 before = direction(0);
  QSignalSpy measured(&placement(), &PlacementController::measuredFocus);
  drag(volume(0), {150, 150}, {330, 190});
  EXPECT_LT(glm::dot(before, direction(0)), 0.9);
  const auto& options = placement().settings().options;
  EXPECT_TRUE(placement::inRegion(direction(0), direction(1), options));
  const auto dual = placement::chooseDual(*placement().measured(), direction(0), options);
  ASSERT_TRUE(dual.c2);
  EXPECT_LT(glm::distance(direction(1), candidate(*dual.c2)), same);

  QTest::mouseClick(window_->camerasPanel().follow(), Qt::LeftButton, {},
                    QPoint(6, window_->camerasPanel().follow()->height() / 2));
  ASSERT_FALSE(placement().settings().follow);
  const double angle = glm::dot(direction(0), direction(1));
  drag(volume(0), {150, 150}, {250, 120});
  EXPECT_NEAR(glm::dot(direction(0), direction(1)), angle, same) << "the linked pair keeps its relation";
  EXPECT_TRUE(measured.isEmpty());
  waitUntilDrawn();
}

TEST_F(PlacedWindow, WeightsAndRegionMoveTheCamerasWithoutMeasuring) {
  QSignalSpy measured(&placement(), &PlacementController::measuredFocus);
  const glm::dvec3 before = direction(0);
  // As the paper has it: larger for larger depth, and so from the far side.
  window_->camerasPanel().weight(0)->box()->setValue(2.0);
  window_->camerasPanel().weight(1)->box()->setValue(0.0);
  waitUntilDrawn();
  EXPECT_LT(glm::dot(direction(0), before), 0.0);
  EXPECT_LT(glm::dot(direction(0), glm::normalize(markerCentre)), -0.9);
  QTest::keyClick(window_->camerasPanel().region(), Qt::Key_Down);
  EXPECT_EQ(placement().settings().options.region, placement::Region::Stream);
  waitUntilDrawn();
  EXPECT_TRUE(placement::inRegion(direction(0), direction(1), placement().settings().options));
  EXPECT_TRUE(measured.isEmpty());
  EXPECT_FALSE(placement().isMeasuring());
}

TEST_F(PlacedWindow, ThumbnailsAndMapTakeC1There) {
  CamerasPanel& panel = window_->camerasPanel();
  const std::vector<std::size_t> best = placement().best(CamerasPanel::thumbnailCount);
  ASSERT_EQ(best.size(), CamerasPanel::thumbnailCount);
  for (std::size_t rank = 0; rank < best.size(); ++rank) EXPECT_FALSE(panel.thumbnail(rank)->icon().isNull());
  QTest::mouseClick(panel.thumbnail(2), Qt::LeftButton);
  waitUntilDrawn();
  EXPECT_LT(glm::distance(direction(0), candidate(best[2])), same);

  const glm::dvec3 wanted = glm::normalize(glm::dvec3(-0.3, -1.0, 0.4));
  QTest::mouseClick(panel.map(), Qt::LeftButton, {}, panel.map()->widgetFromDirection(wanted).toPoint());
  waitUntilDrawn();
  // The map is some 120 device-independent pixels high: a pixel is about 1.5 degrees.
  EXPECT_GT(glm::dot(direction(0), wanted), std::cos(glm::radians(3.0)));
  EXPECT_TRUE(placement::inRegion(direction(0), direction(1), placement().settings().options));
}

TEST(WindowWithoutOpenGl, ExplainsItselfAndKeepsTheSlices) {
  MainWindow window({.gl = {.problem = QStringLiteral("No driver here.")}, .remember = false});
  window.resize(1280, 800);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QSignalSpy opened(&window, &MainWindow::opened);
  window.open([](const io::Progress&) { return markedBall(); });
  ASSERT_TRUE(opened.wait(patience));
  const auto* reason = window.findChild<QLabel*>(QStringLiteral("noOpenGl"));
  ASSERT_NE(reason, nullptr);
  EXPECT_TRUE(reason->isVisible());
  EXPECT_TRUE(reason->text().contains(QStringLiteral("No driver here.")));
  EXPECT_FALSE(window.camerasPanel().placeButton()->isEnabled());
  SliceView* axial = window.views().sliceViews().front();
  window.cursor().moveTo(markerCentre);
  QTest::mouseClick(axial, Qt::LeftButton, {}, axial->widgetFromWorld(markerCentre).toPoint());
  EXPECT_EQ(window.document().focus(), Focus(LabelFocus{{marker}}));
  EXPECT_FALSE(window.picture().isNull());
}

}  // namespace
}  // namespace fenestra::viewer
