// When the window draws what: while it is used and at rest, and what light, backdrop and opening change.

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
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
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer::windowDrawingTest {
namespace {

TEST_F(Window, WhatChangesWhilePicturesAreDrawnIsShownWithThem) {
  waitUntilDrawn();
  long repaints = 0;
  QObject::connect(volume(0), &VolumeView::drawn, window_.get(), [&] { ++repaints; });
  const long frames = views().pacer().frames();
  // While programs are compiled in the background a moving picture may be so late that the one at rest takes its place.
  for (int turn = 0; turn < 20 && views().pacer().frames() == frames; ++turn) {
    repaints = 0;
    cameras().orbit(0, 0.1, 0.0);
    window_->statusBar()->showMessage(QStringLiteral("while both views draw %1").arg(turn));
    const auto isShown = [&] { return views().pacer().frames() > frames || views().isSettled(); };
    ASSERT_TRUE(QTest::qWaitFor(isShown, patience));
  }
  EXPECT_EQ(views().pacer().frames(), frames + 1);
  EXPECT_EQ(repaints, 1);
}

/// Or a thread that prepares a picture could end the program, see PictureSurface.
TEST_F(Window, IsPutTogetherByOpenGlWithAGraphicsCardOnly) {
  EXPECT_EQ(window_->findChildren<QOpenGLWidget*>().size(), gl_.software ? 0 : ViewLink::count);
}

TEST_F(Window, TheEndOfADragIsFollowedByThePictureAtRest) {
  waitUntilDrawn();
  const long frames = views().pacer().frames();
  const glm::dvec3 eye = cameras().camera(0).eye;
  drag(volume(0), {60, 60}, {90, 60});  // within one event: the frame of its last step is still due
  waitUntilDrawn();
  EXPECT_NE(cameras().camera(0).eye, eye);
  EXPECT_EQ(views().pacer().frames(), frames);
  EXPECT_EQ(volume(0)->finishedPicture()->view.camera,
            cameras().camera(0).fittedTo(static_cast<double>(volume(0)->width()) / volume(0)->height()));
}

TEST_F(Window, AtRestTheStatusBarTellsOfThePictureAtRest) {
  const auto tellsOfSmaller = [this] {
    for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>())
      if (label->text().contains(QStringLiteral("% size"))) return true;
    return false;
  };
  for (int turn = 0; turn < 5; ++turn) {
    cameras().orbit(0, 0.1, 0.0);
    QTest::qWait(30);
    waitUntilDrawn();
    EXPECT_FALSE(tellsOfSmaller()) << "turn " << turn;
  }
}

TEST_F(Window, LightSlidersChangeThePictureAndAreUndone) {
  waitUntilDrawn();
  const QImage before = picture(volume(0));
  const Shading shading = document().look().shading;
  for (const char* key : {"light_azimuth", "light_elevation"}) {
    auto* slider = window_->findChild<SliderSpin*>(QString::fromUtf8(key));
    ASSERT_NE(slider, nullptr) << key;
    slider->box()->setValue(-60.0);
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << key;
    document().undoStack().undo();
    EXPECT_EQ(document().look().shading, shading) << key;
    EXPECT_EQ(slider->box()->value(),
              std::round(key == std::string("light_azimuth") ? shading.lightAzimuth : shading.lightElevation));
    waitUntilDrawn();
    EXPECT_EQ(picture(volume(0)), before) << key;
  }
}

TEST_F(Window, OcclusionAndShadowChangeThePictureAndAreUndone) {
  waitUntilDrawn();
  const QImage before = picture(volume(0));
  const Shading shading = document().look().shading;
  for (const char* key : {"occlusion", "shadow"}) {
    auto* slider = window_->findChild<SliderSpin*>(QString::fromUtf8(key));
    ASSERT_NE(slider, nullptr) << key;
    EXPECT_EQ(slider->box()->value(), 0.0) << key;
    slider->box()->setValue(0.8);
    EXPECT_NE(document().look().shading, shading) << key;
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << key;
    document().undoStack().undo();
    EXPECT_EQ(document().look().shading, shading) << key;
    EXPECT_EQ(slider->box()->value(), 0.0) << key;
    waitUntilDrawn();
    EXPECT_EQ(picture(volume(0)), before) << key;
  }
}

TEST_F(Window, TheBackgroundIsChosenAndUndone) {
  waitUntilDrawn();
  const glm::dvec3 before = document().look().background;
  auto* button = window_->findChild<ColourButton*>(QStringLiteral("background"));
  QTimer::singleShot(0, qApp, [] {
    for (QWidget* top : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QColorDialog*>(top)) {
        dialog->setCurrentColor(QColor(40, 80, 120));
        dialog->accept();
      }
  });
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_NE(document().look().background, before);
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)).pixelColor(40, 60), QColor(40, 80, 120));
  document().undoStack().undo();
  EXPECT_EQ(document().look().background, before);
}

TEST_F(Window, Thorough_LightBackdropAndLabelSurfacesAreChosenAndUndone) {
  document().focusOn(marker);
  waitUntilDrawn();
  const QImage before = picture(volume(0));
  const Look look = document().look();
  for (const char* name : {"light_preset", "backdrop", "label_smoothing"}) {
    auto* box = window_->findChild<QComboBox*>(QString::fromUtf8(name));
    ASSERT_NE(box, nullptr) << name;
    EXPECT_EQ(box->currentIndex(), 0) << name;
    const int steps = document().undoStack().index();
    box->setCurrentIndex(1);
    Q_EMIT box->activated(1);
    EXPECT_EQ(document().undoStack().index(), steps + 1) << name;
    waitUntilDrawn();
    EXPECT_NE(picture(volume(0)), before) << name;
    document().undoStack().undo();
    EXPECT_EQ(document().look(), look) << name;
    EXPECT_EQ(box->currentIndex(), 0) << name;
    waitUntilDrawn();
    EXPECT_EQ(picture(volume(0)), before) << name;
  }
}

TEST_F(Window, AGradientIsTheTopsColourAtTheTopAlone) {
  Look look = document().look();
  look.background = {0.0, 0.0, 0.0};
  look.backdrop = Backdrop::Gradient;
  look.backgroundTop = {1.0, 0.0, 0.0};
  document().edit(QStringLiteral("Backdrop"), look);
  waitUntilDrawn();
  const QImage shown = picture(volume(0));
  // Beside the body and the text in the corners. A frame of a pixel is around the picture, and a row is 0.7 of 255.
  const int column = shown.width() / 3;
  EXPECT_NEAR(shown.pixelColor(column, 4).red(), 255.0 * (1.0 - 4.5 / shown.height()), 1.5);
  EXPECT_NEAR(shown.pixelColor(column, shown.height() - 5).red(), 255.0 * 4.5 / shown.height(), 1.5);
  EXPECT_EQ(shown.pixelColor(column, 4).green(), 0);
}

TEST_F(Window, OpeningSliderChangesThePicture) {
  document().focusOn(marker);
  waitUntilDrawn();
  const QImage before = picture(volume(0));
  QSlider* slider = panel<CutawayPanel>().openWidth()->slider();
  const double width = document().scene().look.cutaway.openWidth;
  const int handle = slider->width() * slider->value() / slider->maximum();
  const int steps = document().undoStack().count();
  drag(slider, {handle, slider->height() / 2}, {slider->width() * 3 / 4, slider->height() / 2});
  EXPECT_GT(document().scene().look.cutaway.openWidth, width + 20.0);
  EXPECT_DOUBLE_EQ(panel<CutawayPanel>().openWidth()->box()->value(), document().scene().look.cutaway.openWidth);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), before);

  EXPECT_EQ(document().undoStack().count(), steps + 1) << "a drag is one step";
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().scene().look.cutaway.openWidth, width);
  EXPECT_EQ(panel<CutawayPanel>().openWidth()->box()->value(), width);
  waitUntilDrawn();
  EXPECT_EQ(picture(volume(0)), before);
}

TEST_F(Window, QualityAtRestIsChosenAndSaid) {
  QAction* choice = nullptr;
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->text() == QStringLiteral("Error ≤ 4/255")) choice = action;
  ASSERT_NE(choice, nullptr);
  EXPECT_FALSE(choice->isChecked());
  choice->trigger();
  EXPECT_TRUE(choice->isChecked());
  EXPECT_EQ(volume(0)->restView().maxError, 4.0);
  EXPECT_FALSE(volume(0)->isSettled());
  waitUntilDrawn();
  const auto said = [&] {
    for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>())
      if (label->text().contains(QStringLiteral("s, error ≤ 4/255"))) return true;
    return false;
  };
  EXPECT_TRUE(QTest::qWaitFor(said, patience));
}

TEST_F(Window, Thorough_InputEndsARefinementAndThePictureAtRestIsTheSame) {
  views().setAtRest(Quality::Normal, 0.5);
  waitUntilDrawn();
  const ViewLink::Pose pose = cameras().pose();
  const QImage atRest = picture(volume(0));
  // Turned away and back, and at other moments of the refinement each time.
  for (const int milliseconds : {105, 130, 170, 230}) {
    volume(0)->redraw();
    QTest::qWait(milliseconds);
    cameras().orbit(0, 0.4, 0.2);
    QApplication::processEvents();
    cameras().setPose(pose);
    waitUntilDrawn();
    EXPECT_EQ(picture(volume(0)), atRest) << "after " << milliseconds << " ms";
  }
}

TEST_F(Window, ThePictureAtRestIsThatOfOneRun) {
  views().setAtRest(Quality::Normal, {});
  waitUntilDrawn();
  options().setText(false);
  options().setCrosshair(false);
  waitUntilDrawn();
  const QImage shown = volume(0)->grabSurface();
  std::vector<std::uint8_t> whole;
  const View view = volume(0)->restView();
  ASSERT_TRUE(volume(0)->inGlContext([&](const std::shared_ptr<GpuScene>& gpu) {
    Renderer renderer(gpu);
    renderer.render(document().scene(), view);
    whole = renderer.readPicture();
  }));
  ASSERT_EQ(shown.size(), QSize(view.size.x, view.size.y));
  // The overlay is in the corners; the presentation rounds to eight bits as reading does, to within one.
  for (int y = view.size.y / 4; y < view.size.y * 3 / 4; ++y)
    for (int x = view.size.x / 4; x < view.size.x * 3 / 4; ++x) {
      const QColor colour = shown.pixelColor(x, y);
      const std::uint8_t* wanted = &whole[4 * static_cast<std::size_t>(y * view.size.x + x)];
      ASSERT_LE(std::abs(colour.red() - wanted[0]), 1) << x << ", " << y;
      ASSERT_LE(std::abs(colour.green() - wanted[1]), 1) << x << ", " << y;
      ASSERT_LE(std::abs(colour.blue() - wanted[2]), 1) << x << ", " << y;
    }
}

}  // namespace
}  // namespace fenestra::viewer::windowDrawingTest
