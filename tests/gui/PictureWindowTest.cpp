// Saved and copied pictures, and turntables.

#include <fstream>
#include <numbers>

#include <QApplication>
#include <QClipboard>
#include <QPainter>
#include <QProgressDialog>
#include <QPushButton>
#include <QTest>

#include "io/ImageWriter.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/dialogs/PictureDialog.h"
#include "viewer/exports/PictureExports.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer::pictureWindowTest {
namespace fs = std::filesystem;
namespace {

QImage load(const fs::path& path) { return QImage(toQString(path)).convertToFormat(QImage::Format_RGB32); }

/// Mean over pixels and channels of the difference, 0 to 255.
double meanDifference(const QImage& a, const QImage& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
      sum += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
    }
  return sum / (3.0 * a.width() * a.height());
}

}  // namespace

class PictureWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    document().focusOn(marker);
    waitUntilDrawn();
  }
  PictureExports& pictures() { return window_->pictures(); }
  void waitUntilWritten() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !pictures().isBusy(); }, patience));
  }
  PictureMaker::Request ofBoth() { return {.volumes = views().volumeViews()}; }
  PictureMaker::Request ofAll() { return {.volumes = views().volumeViews(), .slices = views().sliceViews()}; }

  const fs::path folder_ = tests::scratchFolder();
};

TEST_F(PictureWindow, ASavedPictureIsWhatTheWindowShows) {
  Look look = document().look();
  look.background = {0.2, 0.4, 0.6};  // whole numbers of 255ths
  document().edit(QStringLiteral("background"), look);
  qApp->focusWidget()->clearFocus();
  waitUntilDrawn();
  pictures().writePicture(folder_ / "views.png", ofAll());
  waitUntilWritten();
  const QImage saved = load(folder_ / "views.png");
  ASSERT_EQ(saved.size(), views().size());
  for (VolumeView* view : views().volumeViews()) {
    const QRect place(view->mapTo(&views(), QPoint(0, 0)), view->size());
    // QPainter smooths lines in another way on OpenGL than in an image: some hundred pixels of the mark and the cube.
    EXPECT_LT(meanDifference(saved.copy(place), view->grabSurface()), 0.2);
  }
  const QRect axial(slice(SlicePlane::Axial)->mapTo(&views(), QPoint(0, 0)), slice(SlicePlane::Axial)->size());
  EXPECT_EQ(meanDifference(saved.copy(axial), slice(SlicePlane::Axial)->grab().toImage()), 0.0);
}

TEST_F(PictureWindow, Thorough_ASavedPictureSaysHowFaithfulItIs) {
  Look look = document().look();
  look.clipping.planes = {{glm::dvec3(1.0, 0.0, 0.0), 0.0}};
  document().edit(QStringLiteral("clip"), look);
  waitUntilDrawn();
  PictureMaker::Request request = ofAll();
  pictures().writePicture(folder_ / "plain.png", request);
  waitUntilWritten();
  request.causes = true;
  pictures().writePicture(folder_ / "told.png", request);
  waitUntilWritten();
  for (const char* name : {"plain.png", "told.png"}) {
    const QString text = load(folder_ / name).text(QStringLiteral("Fidelity"));
    EXPECT_TRUE(text.contains(QStringLiteral("C1: altered; a part of the volume is clipped, by 1 plane")))
        << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("no bound (quality: draft)"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("Axial: faithful"))) << text.toStdString();
  }
  EXPECT_GT(meanDifference(load(folder_ / "plain.png"), load(folder_ / "told.png")), 0.0) << "the lines are written";
  options().setText(false);
  pictures().writePicture(folder_ / "silent.png", request);
  waitUntilWritten();
  request.causes = false;
  pictures().writePicture(folder_ / "plain2.png", request);
  waitUntilWritten();
  EXPECT_EQ(load(folder_ / "silent.png"), load(folder_ / "plain2.png")) << "where texts do not show";
}

TEST_F(PictureWindow, ALargerPictureShowsTheSameWithMoreDetail) {
  pictures().writePicture(folder_ / "once.png", ofBoth());
  waitUntilWritten();
  PictureMaker::Request request = ofBoth();
  request.scale = 2.5;
  pictures().writePicture(folder_ / "larger.png", request);
  waitUntilWritten();
  const QImage once = load(folder_ / "once.png"), larger = load(folder_ / "larger.png");
  EXPECT_EQ(larger.size(), (QSizeF(once.size()) * 2.5).toSize());
  const QImage reduced = larger.scaled(once.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  // Edges are sharper than in the small picture; where they lie must be the same.
  EXPECT_LT(meanDifference(reduced, once), 1.5);
}

/// A picture of the window's views of 1000 × 750 pixels, so many times as large.
class DensePicture : public PictureWindow {
 protected:
  void expectScaled(double scale);
};

void DensePicture::expectScaled(double scale) {
  window_->resize(window_->size() + QSize(1000, 750) - views().size());
  ASSERT_TRUE(QTest::qWaitFor([&] { return views().size() == QSize(1000, 750); }, patience));
  qApp->focusWidget()->clearFocus();
  cursor().moveTo(markerCentre);
  waitUntilDrawn();
  PictureMaker::Request request = ofAll();
  request.scale = scale;
  pictures().writePicture(folder_ / "large.png", request);
  waitUntilWritten();
  const QImage saved = load(folder_ / "large.png");
  ASSERT_EQ(saved.size(), QSize(1000, 750) * scale);
  const auto placeOf = [&](const QWidget* view) { return QRect(view->mapTo(&views(), QPoint(0, 0)), view->size()); };
  // A slice as a screen of that density shows it, text and lines included.
  for (SliceView* view : views().sliceViews()) {
    QImage dense(view->size() * scale, QImage::Format_RGB32);
    dense.setDevicePixelRatio(scale);
    QPainter painter(&dense);
    view->draw(painter, true);
    painter.end();
    dense.setDevicePixelRatio(1.0);
    const QRect place = placeOf(view);
    EXPECT_EQ(meanDifference(saved.copy(QRect(place.topLeft() * scale, place.size() * scale)), dense), 0.0)
        << view->objectName().toStdString();
  }
  // A 3-D view has no picture for such a screen to compare with: the saved one must be that on screen, with sharper
  // edges.
  for (VolumeView* view : views().volumeViews()) {
    const QRect place = placeOf(view);
    const QImage large = saved.copy(QRect(place.topLeft() * scale, place.size() * scale));
    const QImage reduced = large.scaled(place.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    EXPECT_LT(meanDifference(reduced, view->grabSurface()), 1.5) << view->objectName().toStdString();
  }
}

TEST_F(DensePicture, Thorough_APictureOf2000By1500IsTheWindowOnADenserScreen) { expectScaled(2.0); }

TEST_F(DensePicture, APictureOf4000By3000IsTheWindowToo) { expectScaled(4.0); }

TEST_F(PictureWindow, WithoutMarksOnlyThePictureIsSaved) {
  const fs::path with = folder_ / "with.png", without = folder_ / "without.png";
  PictureMaker::Request request{.volumes = {volume(0)}};
  pictures().writePicture(with, request);
  waitUntilWritten();
  request.marks = false;
  pictures().writePicture(without, request);
  waitUntilWritten();
  EXPECT_NE(load(with), load(without));
  // The cube in the lower left corner is drawn over the background.
  const QPoint cube(30, volume(0)->height() - 30);
  EXPECT_NE(load(with).pixel(cube), qRgb(0, 0, 0));
  EXPECT_EQ(load(without).pixel(cube), qRgb(0, 0, 0));
}

TEST_F(PictureWindow, CopyTakesTheActiveView) {
  slice(SlicePlane::Coronal)->setFocus();
  QTest::keyClick(window_.get(), Qt::Key_C, Qt::ControlModifier);
  waitUntilWritten();
  EXPECT_EQ(QApplication::clipboard()->image().size(), slice(SlicePlane::Coronal)->size());
  volume(1)->setFocus();
  QTest::keyClick(window_.get(), Qt::Key_C, Qt::ControlModifier);
  waitUntilWritten();
  EXPECT_EQ(QApplication::clipboard()->image().size(), volume(1)->size());
}

TEST_F(PictureWindow, ATurntableTurnsOnceRound) {
  PictureMaker::Request request{.volumes = {volume(0)}, .scale = 0.5, .marks = false};
  pictures().writeTurntable(folder_ / "turn.png", request, 4, 24);
  waitUntilWritten();
  pictures().writePicture(folder_ / "front.png", request);
  waitUntilWritten();
  std::vector<QImage> frames;
  for (int i = 1; i <= 4; ++i) frames.push_back(load(folder_ / ("turn-000" + std::to_string(i) + ".png")));
  EXPECT_FALSE(fs::exists(folder_ / "turn-0005.png"));
  EXPECT_EQ(frames[0], load(folder_ / "front.png"));
  for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_GT(meanDifference(frames[i], frames[0]), 1.0) << i;
  // Two turns of a quarter by hand are the third picture.
  const Camera behind = cameras().camera(0).orbited(std::numbers::pi, 0.0);
  cameras().place({behind, behind.beside()});
  waitUntilDrawn();
  pictures().writePicture(folder_ / "back.png", request);
  waitUntilWritten();
  EXPECT_LT(meanDifference(frames[2], load(folder_ / "back.png")), 0.05);
}

TEST_F(PictureWindow, ACancelledTurntableLeavesNothing) {
  pictures().writeTurntable(folder_ / "turn.png", ofBoth(), 200, 24);
  ASSERT_TRUE(QTest::qWaitFor([&] { return fs::exists(folder_ / "turn-0002.png"); }, patience));
  auto* progress = window_->findChild<QProgressDialog*>();
  ASSERT_NE(progress, nullptr);
  QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
  waitUntilWritten();
  QTest::qWait(50);
  EXPECT_TRUE(fs::is_empty(folder_));
  waitUntilDrawn();
}

TEST_F(PictureWindow, ATurntableReplacesNoOlderPictures) {
  std::ofstream(folder_ / "turn-0003.png") << "older";
  pictures().writeTurntable(folder_ / "turn.png", ofBoth(), 4, 24);
  EXPECT_FALSE(pictures().isBusy());
  ASSERT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("turn-0003.png")));
  std::ifstream kept(folder_ / "turn-0003.png");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), "older");
  EXPECT_FALSE(fs::exists(folder_ / "turn-0001.png"));
}

TEST_F(PictureWindow, AFolderThatCannotBeWrittenIsSaid) {
  pictures().writePicture(folder_ / "absent" / "a.png", ofBoth());
  waitUntilWritten();
  ASSERT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("a.png")));
}

TEST_F(PictureWindow, WithoutA3DViewThereIsNoTurntable) {
  views().toggleMaximised(slice(SlicePlane::Axial));
  pictures().chooseTurntable();  // no dialog, which would wait for an answer
  EXPECT_TRUE(window_->notices().texts().front().startsWith(QStringLiteral("No 3-D view")));
}

TEST_F(PictureWindow, AFilmIsWrittenWhereFfmpegIs) {
  if (!PictureExports::canWriteFilms()) GTEST_SKIP() << "needs the program ffmpeg";
  PictureMaker::Request request{.volumes = {volume(0)}, .scale = 0.3};
  pictures().writeTurntable(folder_ / "turn.mp4", request, 5, 24);
  waitUntilWritten();
  EXPECT_GT(fs::file_size(folder_ / "turn.mp4"), 500u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(PictureWindow, APictureThatFitsNoMemoryIsSaid) {
  pictures().writePicture(folder_ / "a.png", {.volumes = {volume(0)}, .scale = 1e5});
  EXPECT_FALSE(pictures().isBusy());
  EXPECT_TRUE(window_->notices().texts().front().startsWith(QStringLiteral("There is no memory for a picture")));
}

TEST_F(PictureWindow, AProgramForFilmsThatFailsIsQuoted) {
  const QByteArray path = qgetenv("PATH");
  const fs::path program = folder_ / "ffmpeg";
  const auto write = [&](const std::string& script) {
    std::ofstream(program) << script;
    fs::permissions(program, fs::perms::owner_all);
    pictures().writeTurntable(folder_ / "turn.mp4", {.volumes = {volume(0)}, .scale = 0.3}, 3, 24);
    waitUntilWritten();
  };
  qputenv("PATH", QByteArray::fromStdString(folder_.string()) + ':' + path);
  write("#!/bin/sh\ncat > /dev/null\necho no such encoder >&2\nexit 1\n");
  EXPECT_TRUE(window_->notices().texts().front().endsWith(QStringLiteral("no such encoder")));
  write("#!/no/such/program\n");
  EXPECT_TRUE(window_->notices().texts().front().startsWith(QStringLiteral("ffmpeg cannot be started")));
  qputenv("PATH", path);
  EXPECT_FALSE(fs::exists(folder_ / "turn.mp4"));
}

TEST_F(PictureWindow, TheDialogKeepsTheViewsShape) {
  volume(1)->setFocus();
  PictureMaker maker(views());
  PictureDialog dialog(PictureDialog::What::Picture, views(), maker);
  EXPECT_EQ(dialog.request().volumes, std::vector<VolumeView*>{volume(1)});
  EXPECT_NEAR(dialog.request().scale, window_->devicePixelRatioF(), 0.01);
  const QList<QSpinBox*> sides = dialog.findChildren<QSpinBox*>();
  sides[0]->setValue(3 * volume(1)->width());
  EXPECT_EQ(sides[1]->value(), 3 * volume(1)->height());
  sides[1]->setValue(volume(1)->height());
  EXPECT_NEAR(dialog.request().scale, 1.0, 0.01);
}

}  // namespace fenestra::viewer::pictureWindowTest
